#include "geometry/tessellate/grid_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"

namespace blossom {
namespace {

constexpr std::size_t maximumPoints = std::size_t{1} << 24;

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
  Steps minimumU,
      minimumV;  ///< what the angle asks for, and what keeps within the chord where the middle of a step does not tell
};

/// Steps so that the second-order error h^2 |S''| / 8 keeps within a third of the chord in each direction, and the normal
/// within the angle. Only the part of S'' along the normal bends the surface; the rest is parametrisation. A turn that bends
/// the surface by less than a fifth of the chord is too small to be seen and may exceed the angle.
Fineness estimate(const Surface& surface, const std::vector<double>& breaksU, const std::vector<double>& breaksV,
                  const TessellationOptions& options, const Progress& progress) {
  constexpr int maximumByAngle = 64;
  constexpr double seen = 0.2;
  constexpr std::array<double, 4> places{0.02, 0.35, 0.65, 0.98};
  const Steps onesU(breaksU.size() - 1, 1), onesV(breaksV.size() - 1, 1);
  Fineness fineness{onesU, onesV, onesU, onesV};
  const auto lift = [](int& steps, double wanted) {
    if (wanted > steps) steps = static_cast<int>(std::ceil(std::min(wanted, 1e4)));
  };
  // `turn`: of the normal, in radians by the parameter; `byTwist`: steps within which a twist is too small to be seen
  const auto raise = [&](int& steps, int& minimum, double span, double bend, double turn, double byTwist) {
    const double byAngle = std::min<double>(maximumByAngle, span * turn / options.angle);
    const double byBend = span * std::sqrt(bend / (8 * options.chord));
    lift(minimum, std::max(byBend, std::min(byAngle, std::max(byBend / std::sqrt(seen), byTwist))));
    lift(steps, std::max<double>(minimum, byBend * std::sqrt(3)));
  };
  const auto turnOf = [](double bend, double speed, double twist, double across) {
    return std::hypot(speed > 0 ? bend / speed : 0, across > 0 ? twist / across : 0);
  };
  for (std::size_t a = 0; a + 1 < breaksU.size(); ++a) {
    progress.check();
    for (std::size_t b = 0; b + 1 < breaksV.size(); ++b) {
      for (const double pu : places) {
        for (const double pv : places) {
          const double spanU = breaksU[a + 1] - breaksU[a];
          const double spanV = breaksV[b + 1] - breaksV[b];
          const SecondOrder at = secondOrder(surface, breaksU[a] + pu * spanU, breaksV[b] + pv * spanV);
          const double byTwist = at.bendUV * spanU * spanV / (4 * seen * options.chord);
          const double turnU = turnOf(at.bendUU, at.speedU, at.bendUV, at.speedV),
                       turnV = turnOf(at.bendVV, at.speedV, at.bendUV, at.speedU);
          raise(fineness.u[a], fineness.minimumU[a], spanU, at.bendUU, turnU, byTwist);
          raise(fineness.v[b], fineness.minimumV[b], spanV, at.bendVV, turnV, byTwist);
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
  GridFitter(const Surface& surface, const TessellationOptions& options, GridBorder border, const Progress& progress)
      : surface_(surface),
        options_(options),
        border_(border),
        progress_(progress),
        breaksU_(domainBreaks(surface.degreeU, surface.knotsU)),
        breaksV_(domainBreaks(surface.degreeV, surface.knotsV)),
        fineness_(estimate(surface, breaksU_, breaksV_, options, progress)) {
    const int minimumSteps = border == GridBorder::Shared ? 2 : 1;
    for (Steps* minimum : {&fineness_.minimumU, &fineness_.minimumV})
      if (static_cast<int>(minimum->size()) < minimumSteps) minimum->front() = std::max(minimum->front(), minimumSteps);
  }

  SurfaceGrid run() {
    // The estimate is cautious: where the errors turn out small, fewer steps do. First both directions get their share of
    // the chord, for the errors add up; then what is left of it.
    const Errors first = measured(2);
    relax(fineness_.u, fineness_.minimumU, first.u, 0.45);
    relax(fineness_.v, fineness_.minimumV, first.v, 0.45);
    const Errors second = measured(2);
    relax(fineness_.u, fineness_.minimumU, second.cellsU, 0.8);
    relax(fineness_.v, fineness_.minimumV, second.cellsV, 0.8);
    refineUntilWithinChord();
    return evaluated(1, GridNormals::Yes);
  }

 private:
  /// Largest error in each span of knots.
  struct Errors {
    std::vector<double> u, v;            ///< by the bend in that direction
    std::vector<double> cellsU, cellsV;  ///< of all cells in the span, whatever the reason
  };

  SurfaceGrid evaluated(int times, GridNormals normals) const {
    const Kinks kinks = border_ == GridBorder::Own ? Kinks::Twice : Kinks::Once;
    const auto u = samples(surface_.degreeU, surface_.knotsU, breaksU_, fineness_.u, times, kinks);
    const auto v = samples(surface_.degreeV, surface_.knotsV, breaksV_, fineness_.v, times, kinks);
    if (u.size() * v.size() > maximumPoints)
      throw Error(ErrorCode::LimitExceeded, "The surface needs too many triangles for this chord.", "Give a larger chord.");
    return evaluateGrid(surface_, u, v, progress_, normals);
  }

  /// At `parts` - 1 places on every side and diagonal of the cells.
  Errors measured(int parts) const {
    const SurfaceGrid fine = evaluated(parts, GridNormals::No);
    const auto step = static_cast<std::size_t>(parts);
    Errors errors{std::vector<double>(fineness_.u.size()), std::vector<double>(fineness_.v.size()), {}, {}};
    errors.cellsU = errors.u;
    errors.cellsV = errors.v;
    for (std::size_t i = 0; i + step < fine.u.size(); ++i) {
      if (fine.u[i].between || !fine.connectedU(i)) continue;
      for (std::size_t j = 0; j + step < fine.v.size(); ++j)
        if (!fine.v[j].between && fine.connectedV(j)) addCell(errors, fine, i, j, step);
    }
    return errors;
  }

  void addCell(Errors& errors, const SurfaceGrid& fine, std::size_t i, std::size_t j, std::size_t step) const {
    const std::size_t spanU = fine.u[i + 1].interval, spanV = fine.v[j + 1].interval;
    const auto at = [&](std::size_t k, std::size_t l) -> const Vec3& { return fine.point(i + k, j + l); };
    const bool main = mainDiagonal(at(0, 0), at(step, 0), at(0, step), at(step, step));
    const bool both = border_ == GridBorder::Shared &&
                      (i == 0 || j == 0 || i + step + 1 == fine.u.size() || j + step + 1 == fine.v.size());
    double sideU = 0, sideV = 0, inside = 0;
    for (std::size_t k = 1; k < step; ++k) {
      sideU = std::max({sideU, distanceToSegment(at(k, 0), at(0, 0), at(step, 0)),
                        distanceToSegment(at(k, step), at(0, step), at(step, step))});
      sideV = std::max({sideV, distanceToSegment(at(0, k), at(0, 0), at(0, step)),
                        distanceToSegment(at(step, k), at(step, 0), at(step, step))});
      if (main || both) inside = std::max(inside, distanceToSegment(at(k, k), at(0, 0), at(step, step)));
      if (!main || both) inside = std::max(inside, distanceToSegment(at(k, step - k), at(0, step), at(step, 0)));
    }
    const auto raise = [](double& error, double by) { error = std::max(error, by); };
    // What the diagonal is off counts for the direction that bends more here.
    raise(errors.u[spanU], sideU >= sideV ? std::max(sideU, inside) : sideU);
    raise(errors.v[spanV], sideV > sideU ? std::max(sideV, inside) : sideV);
    raise(errors.cellsU[spanU], std::max({sideU, sideV, inside}));
    raise(errors.cellsV[spanV], std::max({sideU, sideV, inside}));
  }

  void relax(Steps& steps, const Steps& minimum, const std::vector<double>& errors, double share) const {
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const double factor = std::min(1.0, std::sqrt(errors[k] / (share * options_.chord)));
      steps[k] = std::max({1, minimum[k], static_cast<int>(std::ceil(steps[k] * factor))});
    }
  }

  void refineUntilWithinChord() {
    constexpr int maximumRounds = 6;
    for (int round = 0; round < maximumRounds; ++round) {
      const Errors errors = measured(4);
      const bool moreU = refine(fineness_.u, errors.u);
      const bool moreV = refine(fineness_.v, errors.v);
      if (!moreU && !moreV) return;
    }
  }

  bool refine(Steps& steps, const std::vector<double>& errors) const {
    constexpr double margin = 0.85;  // the largest error is not exactly at the places measured
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
  GridBorder border_;
  const Progress& progress_;
  std::vector<double> breaksU_, breaksV_;
  Fineness fineness_;
};

}  // namespace

SurfaceGrid fitGrid(const Surface& surface, const TessellationOptions& options, GridBorder border,
                    const Progress& progress) {
  return GridFitter(surface, options, border, progress).run();
}

}  // namespace blossom
