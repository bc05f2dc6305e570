#include "geometry/grid_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"

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
  Steps leastU, leastV;  ///< what the angle asks for
};

/// Steps so that the second-order error h^2 |S''| / 8 keeps within a third of the chord in each direction, and the normal
/// within the angle. Only the part of S'' along the normal bends the surface; the rest is parametrisation. A turn that bends
/// the surface by less than a fifth of the chord is too small to be seen and may exceed the angle.
Fineness estimate(const Surface& surface, const std::vector<double>& breaksU, const std::vector<double>& breaksV,
                  const TessellationOptions& options) {
  constexpr int mostByAngle = 64;
  constexpr double seen = 0.2;
  constexpr std::array<double, 4> places{0.02, 0.35, 0.65, 0.98};
  const Steps onesU(breaksU.size() - 1, 1), onesV(breaksV.size() - 1, 1);
  Fineness fineness{onesU, onesV, onesU, onesV};
  const auto lift = [](int& steps, double wanted) {
    if (wanted > steps) steps = static_cast<int>(std::ceil(std::min(wanted, 1e4)));
  };
  const auto raise = [&](int& steps, int& least, double span, double bend, double speed) {
    const double byAngle = speed > 0 ? std::min<double>(mostByAngle, span * bend / (speed * options.angle)) : 1;
    lift(least, std::min(byAngle, span * std::sqrt(bend / (8 * seen * options.chord))));
    lift(steps, std::max<double>(least, span * std::sqrt(bend * 3 / (8 * options.chord))));
  };
  for (std::size_t a = 0; a + 1 < breaksU.size(); ++a) {
    for (std::size_t b = 0; b + 1 < breaksV.size(); ++b) {
      for (const double pu : places) {
        for (const double pv : places) {
          const double spanU = breaksU[a + 1] - breaksU[a];
          const double spanV = breaksV[b + 1] - breaksV[b];
          const SecondOrder at = secondOrder(surface, breaksU[a] + pu * spanU, breaksV[b] + pv * spanV);
          raise(fineness.u[a], fineness.leastU[a], spanU, at.bendUU, at.speedU);
          raise(fineness.v[b], fineness.leastV[b], spanV, at.bendVV, at.speedV);
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

class GridFitter {
 public:
  GridFitter(const Surface& surface, const TessellationOptions& options, Kinks kinks, const Progress& progress,
             int leastSteps)
      : surface_(surface),
        options_(options),
        kinks_(kinks),
        progress_(progress),
        breaksU_(domainBreaks(surface.degreeU, surface.knotsU)),
        breaksV_(domainBreaks(surface.degreeV, surface.knotsV)),
        fineness_(estimate(surface, breaksU_, breaksV_, options)) {
    for (Steps* least : {&fineness_.leastU, &fineness_.leastV})
      if (static_cast<int>(least->size()) < leastSteps) least->front() = std::max(least->front(), leastSteps);
  }

  SurfaceGrid run() {
    const Errors first = measured();
    relax(fineness_.u, fineness_.leastU, first.u);
    relax(fineness_.v, fineness_.leastV, first.v);
    refineUntilWithinChord();
    return evaluated(1, GridNormals::Yes);
  }

 private:
  /// Largest error in each span of knots.
  struct Errors {
    std::vector<double> u, v;
  };

  SurfaceGrid evaluated(int times, GridNormals normals) const {
    const auto u = samples(surface_.degreeU, surface_.knotsU, breaksU_, fineness_.u, times, kinks_);
    const auto v = samples(surface_.degreeV, surface_.knotsV, breaksV_, fineness_.v, times, kinks_);
    if (u.size() * v.size() > mostPoints)
      throw Error(ErrorCode::LimitExceeded, "The surface needs too many triangles for this chord.", "Give a larger chord.");
    return evaluateGrid(surface_, u, v, progress_, normals);
  }

  /// At the middles of all cells and cell sides, on a grid twice as fine.
  Errors measured() const {
    const SurfaceGrid fine = evaluated(2, GridNormals::No);
    Errors errors{std::vector<double>(fineness_.u.size()), std::vector<double>(fineness_.v.size())};
    for (std::size_t i = 0; i + 2 < fine.u.size(); ++i) {
      if (fine.u[i].odd || !fine.connectedU(i) || !fine.connectedU(i + 1)) continue;
      for (std::size_t j = 0; j + 2 < fine.v.size(); ++j) {
        if (fine.v[j].odd || !fine.connectedV(j) || !fine.connectedV(j + 1)) continue;
        double& u = errors.u[fine.u[i + 1].interval];
        double& v = errors.v[fine.v[j + 1].interval];
        const double sideU = std::max(sideError(fine, i, j, 2, 0), sideError(fine, i, j + 2, 2, 0));
        const double sideV = std::max(sideError(fine, i, j, 0, 2), sideError(fine, i + 2, j, 0, 2));
        // What the diagonal is off counts for the direction that bends more here.
        const double inside = centerError(fine, i, j);
        u = std::max(u, sideU >= sideV ? std::max(sideU, inside) : sideU);
        v = std::max(v, sideV > sideU ? std::max(sideV, inside) : sideV);
      }
    }
    return errors;
  }

  /// The estimate is cautious: where the error turns out small, fewer steps do. The errors of both directions add up.
  void relax(Steps& steps, const Steps& least, const std::vector<double>& errors) const {
    constexpr double share = 0.45;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const double factor = std::min(1.0, std::sqrt(errors[k] / (share * options_.chord)));
      steps[k] = std::max(least[k], static_cast<int>(std::ceil(steps[k] * factor)));
    }
  }

  void refineUntilWithinChord() {
    constexpr int mostRounds = 6;
    for (int round = 0; round < mostRounds; ++round) {
      const Errors errors = measured();
      const bool moreU = refine(fineness_.u, errors.u);
      const bool moreV = refine(fineness_.v, errors.v);
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

  const Surface& surface_;
  const TessellationOptions& options_;
  Kinks kinks_;
  const Progress& progress_;
  std::vector<double> breaksU_, breaksV_;
  Fineness fineness_;
};

}  // namespace

SurfaceGrid fitGrid(const Surface& surface, const TessellationOptions& options, Kinks kinks, const Progress& progress,
                    int leastSteps) {
  return GridFitter(surface, options, kinks, progress, leastSteps).run();
}

}  // namespace blossom
