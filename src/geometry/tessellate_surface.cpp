#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/surface_grid.h"
#include "geometry/tessellate_parts.h"

namespace blossom {
namespace {

constexpr std::size_t mostPoints = std::size_t{1} << 24;

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0;
  return (p - a - t * along).norm();
}

/// Number of steps in each span of knots of one direction.
using Steps = std::vector<int>;

struct Fineness {
  Steps u, v;
};

/// Steps so that the second-order error h^2 |S''| / 8 keeps within a third of the chord in each direction, and the normal
/// within the angle. Only the part of S'' along the normal bends the surface; the rest is parametrisation.
Fineness estimate(const Surface& surface, const std::vector<double>& breaksU, const std::vector<double>& breaksV,
                  const TessellationOptions& options) {
  constexpr int mostByAngle = 64;
  constexpr std::array<double, 4> places{0.02, 0.35, 0.65, 0.98};
  Fineness fineness{Steps(breaksU.size() - 1, 1), Steps(breaksV.size() - 1, 1)};
  const auto raise = [&](int& steps, double span, double bend, double speed) {
    const double byChord = span * std::sqrt(bend * 3 / (8 * options.chord));
    const double byAngle = speed > 0 ? std::min<double>(mostByAngle, span * bend / (speed * options.angle)) : 1;
    const double wanted = std::max(byChord, byAngle);
    if (wanted > steps) steps = static_cast<int>(std::ceil(std::min(wanted, 1e4)));
  };
  for (std::size_t a = 0; a + 1 < breaksU.size(); ++a) {
    for (std::size_t b = 0; b + 1 < breaksV.size(); ++b) {
      for (const double pu : places) {
        for (const double pv : places) {
          const double spanU = breaksU[a + 1] - breaksU[a];
          const double spanV = breaksV[b + 1] - breaksV[b];
          const SecondOrder at = secondOrder(surface, breaksU[a] + pu * spanU, breaksV[b] + pv * spanV);
          raise(fineness.u[a], spanU, at.bendUU, at.speedU);
          raise(fineness.v[b], spanV, at.bendVV, at.speedV);
          // The twist term h k |Suv| / 4 is shared out to the direction that is still coarse.
          const double twist = at.bendUV * spanU * spanV * 3 / (4 * options.chord);
          const double steps = static_cast<double>(fineness.u[a]) * fineness.v[b];
          if (twist > steps) {
            const double factor = std::sqrt(twist / steps);
            fineness.u[a] = static_cast<int>(std::ceil(std::min(fineness.u[a] * factor, 1e4)));
            fineness.v[b] = static_cast<int>(std::ceil(std::min(fineness.v[b] * factor, 1e4)));
          }
        }
      }
    }
  }
  return fineness;
}

/// Does the cell's diagonal run from (0,0) to (1,1)? The shorter one makes the better triangles.
bool mainDiagonal(const Vec3& p00, const Vec3& p10, const Vec3& p01, const Vec3& p11) {
  return (p11 - p00).squaredNorm() <= (p01 - p10).squaredNorm();
}

class SurfaceTessellator {
 public:
  SurfaceTessellator(const Surface& surface, const TessellationOptions& options, const Progress& progress)
      : surface_(surface),
        options_(options),
        progress_(progress),
        breaksU_(domainBreaks(surface.degreeU, surface.knotsU)),
        breaksV_(domainBreaks(surface.degreeV, surface.knotsV)),
        fineness_(estimate(surface, breaksU_, breaksV_, options)) {}

  Tessellation run() {
    refineUntilWithinChord();
    const SurfaceGrid grid = evaluated(1);
    addCells(grid);
    addBoundary(grid);
    return std::move(result_);
  }

 private:
  SurfaceGrid evaluated(int times) const {
    const auto u = samples(surface_.degreeU, surface_.knotsU, breaksU_, fineness_.u, times);
    const auto v = samples(surface_.degreeV, surface_.knotsV, breaksV_, fineness_.v, times);
    if (u.size() * v.size() > mostPoints)
      throw Error(ErrorCode::LimitExceeded, "The surface needs too many triangles for this chord.", "Give a larger chord.");
    return evaluateGrid(surface_, u, v, progress_);
  }

  /// Checks the middles of all cells and cell sides on a grid twice as fine; what bends more than estimated gets more steps.
  void refineUntilWithinChord() {
    constexpr int mostRounds = 6;
    for (int round = 0; round < mostRounds; ++round) {
      const SurfaceGrid fine = evaluated(2);
      std::vector<double> errorU(fineness_.u.size()), errorV(fineness_.v.size());
      for (std::size_t i = 0; i + 2 < fine.u.size(); ++i) {
        if (fine.u[i].odd || !fine.connectedU(i) || !fine.connectedU(i + 1)) continue;
        for (std::size_t j = 0; j + 2 < fine.v.size(); ++j) {
          if (fine.v[j].odd || !fine.connectedV(j) || !fine.connectedV(j + 1)) continue;
          double& u = errorU[fine.u[i + 1].interval];
          double& v = errorV[fine.v[j + 1].interval];
          u = std::max({u, sideError(fine, i, j, 2, 0), sideError(fine, i, j + 2, 2, 0)});
          v = std::max({v, sideError(fine, i, j, 0, 2), sideError(fine, i + 2, j, 0, 2)});
          const double inside = centerError(fine, i, j);
          if (inside > std::max(u, v)) (u > v ? u : v) = inside;
        }
      }
      const bool moreU = refine(fineness_.u, errorU);
      const bool moreV = refine(fineness_.v, errorV);
      if (!moreU && !moreV) return;
    }
  }

  static double sideError(const SurfaceGrid& grid, std::size_t i, std::size_t j, std::size_t di, std::size_t dj) {
    return distanceToSegment(grid.point(i + di / 2, j + dj / 2), grid.point(i, j), grid.point(i + di, j + dj));
  }

  static double centerError(const SurfaceGrid& grid, std::size_t i, std::size_t j) {
    const Vec3 &p00 = grid.point(i, j), &p10 = grid.point(i + 2, j), &p01 = grid.point(i, j + 2),
               &p11 = grid.point(i + 2, j + 2);
    const Vec3& center = grid.point(i + 1, j + 1);
    return mainDiagonal(p00, p10, p01, p11) ? distanceToSegment(center, p00, p11) : distanceToSegment(center, p10, p01);
  }

  bool refine(Steps& steps, const std::vector<double>& errors) const {
    constexpr double margin = 0.85;  // the largest error is not exactly in the middle
    bool changed = false;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      if (errors[k] <= margin * options_.chord) continue;
      const double factor = std::min(4.0, std::sqrt(errors[k] / (margin * options_.chord)));
      steps[k] = std::max(steps[k] + 1, static_cast<int>(std::ceil(steps[k] * factor)));
      changed = true;
    }
    return changed;
  }

  void addTriangle(std::size_t a, std::size_t b, std::size_t c) {
    const auto& p = result_.points;
    if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a]) return;  // at a pole
    result_.triangles.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
    result_.faceOfTriangle.push_back(0);
  }

  void addCells(const SurfaceGrid& grid) {
    result_.points = grid.points;
    result_.normals = grid.normals;
    const std::size_t countV = grid.v.size();
    for (std::size_t i = 0; i + 1 < grid.u.size(); ++i) {
      if (!grid.connectedU(i)) continue;
      for (std::size_t j = 0; j + 1 < countV; ++j) {
        if (!grid.connectedV(j)) continue;
        const std::size_t p00 = i * countV + j, p10 = p00 + countV, p01 = p00 + 1, p11 = p10 + 1;
        if (mainDiagonal(grid.points[p00], grid.points[p10], grid.points[p01], grid.points[p11])) {
          addTriangle(p00, p10, p11);
          addTriangle(p00, p11, p01);
        } else {
          addTriangle(p00, p10, p01);
          addTriangle(p10, p11, p01);
        }
      }
    }
  }

  /// The four sides, but neither a seam nor a side that is one point.
  void addBoundary(const SurfaceGrid& grid) {
    const std::size_t lastU = grid.u.size() - 1;
    const std::size_t lastV = grid.v.size() - 1;
    std::vector<Vec3> u0, u1, v0, v1;
    for (std::size_t j = 0; j <= lastV; ++j) {
      u0.push_back(grid.point(0, j));
      u1.push_back(grid.point(lastU, j));
    }
    for (std::size_t i = 0; i <= lastU; ++i) {
      v0.push_back(grid.point(i, 0));
      v1.push_back(grid.point(i, lastV));
    }
    addSides(u0, u1);
    addSides(v0, v1);
  }

  void addSides(const std::vector<Vec3>& first, const std::vector<Vec3>& last) {
    const auto differ = [](const Vec3& a, const Vec3& b) { return (a - b).norm() > 1e-7; };
    if (std::equal(first.begin(), first.end(), last.begin(), [&](const Vec3& a, const Vec3& b) { return !differ(a, b); }))
      return;
    for (const auto& side : {first, last})
      if (std::any_of(side.begin(), side.end(), [&](const Vec3& p) { return differ(p, side.front()); }))
        result_.edges.push_back(side);
  }

  const Surface& surface_;
  const TessellationOptions& options_;
  const Progress& progress_;
  std::vector<double> breaksU_, breaksV_;
  Fineness fineness_;
  Tessellation result_;
};

}  // namespace

Tessellation tessellateSurface(const Surface& surface, const TessellationOptions& options, const Progress& progress) {
  return SurfaceTessellator(surface, options, progress).run();
}

}  // namespace blossom
