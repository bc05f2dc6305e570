#include "kernel/begin/motion_from_curve.h"

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "kernel/begin/frame_spline.h"
#include "kernel/begin/polar_fit.h"
#include "kernel/begin/smooth_curve.h"
#include "kernel/begin/turning_spline.h"
#include "kernel/quaternion.h"

namespace blossom::sweep {

namespace {

void requireSizes(const CurveMotionOptions& options) {
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance))
    throw Error(ErrorCode::InvalidParameter, "The tolerance must be above 0.");
  if (!options.profile && (!(options.radius > 0) || !std::isfinite(options.radius)))
    throw Error(ErrorCode::InvalidParameter, "The radius must be above 0.");
  if (options.rows < 4) throw Error(ErrorCode::InvalidParameter, "A full turn needs 4 rows or more.", "Give more rows.");
}

PolarFit sectionOf(const CurveMotionOptions& options, const Progress& progress) {
  if (options.profile)
    return fitProfile(*options.profile,
                      {.tolerance = options.tolerance / 2, .rows = options.rows, .maximumSpans = options.maximumSpans},
                      progress);
  return {evenBreaks(options.rows), std::vector<double>(options.rows, options.radius), 0, 0};
}

Surface orientationOf(const Curve& frames, std::size_t rows, double start) {
  std::vector<Vec4> poles;
  for (const double half : closedTurn(rows, start))
    for (const Vec4& frame : frames.poles) poles.push_back(times(frame, rotationAbout(Vec3::UnitZ(), 2 * half)));
  return unwrapped(3, 3, evenBreaks(rows), frames.knots, std::move(poles), -1);
}

Surface scalingOf(const PolarFit& section, const std::vector<double>& breaks) {
  const std::vector<double> knots = clampedKnots(3, breaks);
  std::vector<Vec4> poles;
  for (const double radius : section.radii) poles.insert(poles.end(), knots.size() - 4, Vec4(radius, 0, 0, 1));
  return unwrapped(3, 3, section.period, knots, std::move(poles), 1);
}

void findSmallestBend(const SmoothCurve& curve, const std::vector<double>& breaks, CurveMotionResult& result) {
  constexpr int places = 32;
  double largest = 0;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    for (int i = 0; i <= places; ++i) {
      const double t = breaks[k] + (breaks[k + 1] - breaks[k]) * i / places;
      const CurvePoint at = curve.at(t);
      const double bend = at.turning().norm() / at.first.norm();
      if (bend > largest) largest = bend, result.bendAt = t;
    }
  // Rounding leaves straight curves with radii of this order.
  result.smallestBend = largest * curve.size() > 1e-9 ? 1 / largest : 0;
}

}  // namespace

CurveMotionResult motionFromCurve(const Curve& given, const CurveMotionOptions& options, const Progress& progress) {
  requireSizes(options);
  const SmoothCurve curve(given);
  const PolarFit section = sectionOf(options, progress.part(0, 0.3));
  CurveMotionResult result;
  result.reach = options.profile ? options.profile->reach() : options.radius;
  const double share = options.tolerance * (options.profile ? 0.5 : 1);
  const FrameSpline frames = fitFrames(curve,
                                       {.tolerance = std::min(share / result.reach, 0.5),
                                        .spans = options.columns,
                                        .maximumSpans = options.maximumSpans,
                                        .normal = options.normal},
                                       progress.part(0.3, 1));
  result.motion.trajectory = curve.curve();
  result.motion.orientation = orientationOf(frames.quaternions, options.rows, section.start);
  result.motion.scaling = scalingOf(section, frames.coarse);
  result.motion.closedU = ClosedU::AntiPeriodic;
  result.motion.point = Vec3::Ones();
  result.closed = curve.closed();
  if (!result.closed) result.cornerAtEnds = curve.cornerAtEnds();
  result.frameDeviation = frames.deviation;
  result.closing = frames.closing;
  result.deviation = result.reach * 2 * std::sin(frames.deviation / 2) + section.deviation;
  result.frameSpans = frames.spans;
  findSmallestBend(curve, frames.coarse, result);
  validate(result.motion);
  return result;
}

}  // namespace blossom::sweep
