#include "kernel/begin/polar_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/angle.h"
#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/shape/motion.h"
#include "kernel/begin/periodic_cubic.h"
#include "kernel/begin/turning_spline.h"

namespace blossom::sweep {

namespace {

constexpr int placesOfSpan = 16;

/// The middle between the two joints that are farthest apart, or the direction of x when there are none.
double startAwayFromCorners(const PolarProfile& profile) {
  std::vector<double> corners;
  for (const auto& joint : profile.joints())
    if (joint.corner) corners.push_back(joint.angle);
  if (corners.empty()) return 0;
  double start = 0, widest = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double next = k + 1 < corners.size() ? corners[k + 1] : corners[0] + fullTurn;
    // Rounding must not choose between gaps of the same width: the first one stays.
    if (next - corners[k] > widest * (1 + 1e-9)) widest = next - corners[k], start = corners[k] + widest / 2;
  }
  return start;
}

/// The radius as a function of the parameter of the turn.
class RadiusOverTurn {
 public:
  RadiusOverTurn(const PolarProfile& profile, std::size_t rows, double start) : profile_(profile), turn_(rows, start) {
    for (const auto& joint : profile.joints()) {
      const double angle = joint.angle - fullTurn * std::floor((joint.angle - start) / fullTurn);
      joints_.emplace(turn_.parameterOf(angle), joint);
    }
  }

  /// Even spans and the joints, without slivers beside them.
  [[nodiscard]] PeriodicBreaks firstBreaks(std::size_t rows) const {
    std::map<double, bool> breaks{{0.0, false}};
    const double least = 0.05 / static_cast<double>(rows);
    for (const auto& [u, joint] : joints_)
      if (joint.corner || (u > least && u < 1 - least && u - std::prev(breaks.end())->first > least))
        breaks[u] = joint.corner;
    for (std::size_t i = 1; i < rows; ++i) {
      const double u = static_cast<double>(i) / static_cast<double>(rows);
      const auto after = breaks.lower_bound(u);
      if ((after == breaks.end() || after->first - u > 5 * least) && u - std::prev(after)->first > 5 * least)
        breaks[u] = false;
    }
    PeriodicBreaks result;
    for (const auto& [u, corner] : breaks) {
      result.at.push_back(u);
      result.corner.push_back(corner);
    }
    return result;
  }

  [[nodiscard]] double radius(double u) const { return profile_.at(turn_.at(u).value).radius; }

  [[nodiscard]] PeriodicValues values(const PeriodicBreaks& breaks) const {
    PeriodicValues result;
    for (std::size_t k = 0; k < breaks.at.size(); ++k) {
      const ClosedTurn::Angle angle = turn_.at(breaks.at[k]);
      const auto joint = joints_.find(breaks.at[k]);
      const PolarProfile::Value value = joint != joints_.end() ? joint->second.value : profile_.at(angle.value);
      result.value.push_back(value.radius);
      result.slopeLeft.push_back(value.slopeLeft * angle.slope);
      result.slopeRight.push_back(value.slopeRight * angle.slope);
    }
    return result;
  }

 private:
  const PolarProfile& profile_;
  ClosedTurn turn_;
  std::map<double, PolarProfile::Joint> joints_;
};

/// The spline as a curve whose first component is the radius.
Curve radiusCurve(const PolarFit& fit) {
  Curve curve{3, unwrappedKnots(3, fit.period), {}};
  const std::size_t n = fit.radii.size();
  for (std::size_t i = 0; i < n + 3; ++i) curve.poles.emplace_back(fit.radii[i % n], 0, 0, 1);
  return curve;
}

/// Halves the spans that miss the tolerance; none are left when nothing changed.
PeriodicBreaks refinedBreaks(const PeriodicBreaks& breaks, const RadiusOverTurn& truth, PolarFit& fit, double tolerance,
                             const Progress& progress) {
  const Curve curve = radiusCurve(fit);
  PeriodicBreaks result;
  fit.deviation = 0;
  for (std::size_t k = 0; k < breaks.at.size(); ++k) {
    progress.check();
    const double from = breaks.at[k], to = k + 1 < breaks.at.size() ? breaks.at[k + 1] : 1;
    double worst = 0;
    for (int i = 0; i < placesOfSpan; ++i) {
      const double u = from + (to - from) * i / placesOfSpan;
      worst = std::max(worst, std::abs(evaluate(curve, u).x() - truth.radius(u)));
    }
    fit.deviation = std::max(fit.deviation, worst);
    result.at.push_back(from);
    result.corner.push_back(breaks.corner[k]);
    if (worst <= tolerance) continue;
    result.at.push_back((from + to) / 2);
    result.corner.push_back(false);
  }
  return result;
}

}  // namespace

PolarFit fitProfile(const PolarProfile& profile, const PolarFitOptions& options, const Progress& progress) {
  PolarFit fit;
  fit.start = startAwayFromCorners(profile);
  const RadiusOverTurn truth(profile, options.rows, fit.start);
  PeriodicBreaks breaks = truth.firstBreaks(options.rows);
  const std::size_t limit = std::max(options.maximumSpans, 4 * breaks.at.size());
  while (true) {
    fit.period = breaks.period();
    fit.radii = interpolatePeriodic(breaks, truth.values(breaks));
    PeriodicBreaks finer = refinedBreaks(breaks, truth, fit, options.tolerance, progress);
    if (finer.at.size() == breaks.at.size()) return fit;
    if (finer.at.size() > limit)
      throw Error(ErrorCode::LimitExceeded,
                  fmt::format("With {} spans the profile still deviates by {:.3g} mm.", breaks.at.size(), fit.deviation),
                  "Ask for a larger tolerance.");
    breaks = std::move(finer);
  }
}

}  // namespace blossom::sweep
