#include "kernel/begin/frame_spline.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/angle.h"
#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "kernel/begin/rotation_minimizing.h"
#include "kernel/cubic_spline.h"
#include "kernel/quaternion.h"

namespace blossom::sweep {

namespace {

/// Parts of a span at whose ends the true frames are known.
constexpr std::size_t partsOfSpan = 16;

/// The breaks of the curve and even ones, except those that would leave slivers beside others.
CubicBreaks firstFrameBreaks(const SmoothCurve& curve, std::size_t spans) {
  const std::vector<double>& given = curve.breaks();
  CubicBreaks result;
  std::size_t next = 0;
  const double step = 1.0 / static_cast<double>(spans);
  const auto add = [&](double at, int multiplicity) {
    result.at.push_back(at);
    result.multiplicity.push_back(multiplicity);
  };
  for (std::size_t k = 0; k < given.size(); ++k) {
    for (; next <= spans && static_cast<double>(next) * step < given[k] - step / 4; ++next)
      if (const double at = static_cast<double>(next) * step; k > 0 && at > given[k - 1] + step / 4) add(at, 1);
    add(given[k], k == 0 || k + 1 == given.size() ? 1 : curve.frameMultiplicity(k));
  }
  return result;
}

/// Frames at the ends of all parts of all spans, as quaternions of one sign.
struct TrueFrames {
  FrameResult frames;
  std::vector<Vec4> quaternions;
};

TrueFrames trueFrames(const SmoothCurve& curve, const CubicBreaks& breaks, const FrameSplineOptions& options,
                      const Progress& progress) {
  std::vector<double> at;
  for (std::size_t k = 0; k + 1 < breaks.at.size(); ++k)
    for (std::size_t i = 0; i < partsOfSpan; ++i)
      at.push_back(breaks.at[k] +
                   (breaks.at[k + 1] - breaks.at[k]) * static_cast<double>(i) / static_cast<double>(partsOfSpan));
  at.push_back(breaks.at.back());
  TrueFrames result{
      rotationMinimizingFrames(curve, at, {.normal = options.normal, .accuracy = options.tolerance / 50}, progress), {}};
  for (const CurveFrame& frame : result.frames.frames) {
    const Vec4 q = rotationOfAxes(frame.normal, frame.binormal(), frame.tangent);
    const bool opposed = !result.quaternions.empty() && q.dot(result.quaternions.back()) < 0;
    result.quaternions.push_back(opposed ? Vec4(-q) : q);
  }
  if (curve.closed()) {
    const Vec4& first = result.quaternions.front();
    result.quaternions.back() = first.dot(result.quaternions.back()) < 0 ? Vec4(-first) : first;
  }
  return result;
}

/// Derivative of the frame's quaternion by the parameter; the closing angle turns it evenly along the arc length.
Vec4 frameSlope(const SmoothCurve& curve, const TrueFrames& truth, std::size_t node, std::size_t piece) {
  const CurvePoint at = curve.at(truth.frames.frames[node].at, piece);
  Vec3 turning = at.turning();
  if (truth.frames.length > 0) turning += truth.frames.closing / truth.frames.length * at.first;
  return times(Vec4(0, turning.x(), turning.y(), turning.z()), truth.quaternions[node]) / 2;
}

Curve interpolateFrames(const SmoothCurve& curve, const CubicBreaks& breaks, const TrueFrames& truth) {
  Rows values(static_cast<Eigen::Index>(breaks.at.size()), 4);
  for (std::size_t k = 0; k < breaks.at.size(); ++k)
    values.row(static_cast<Eigen::Index>(k)) = truth.quaternions[k * partsOfSpan].transpose();
  const auto segments = breaks.segments();
  Rows slopes(static_cast<Eigen::Index>(2 * segments.size()), 4);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto [from, to] = segments[s];
    const auto row = static_cast<Eigen::Index>(2 * s);
    // Just inside the segment: at a knot of the curve that decides the piece.
    const std::size_t last = curve.pieceOf(truth.frames.frames[to * partsOfSpan - 1].at);
    slopes.row(row) = frameSlope(curve, truth, from * partsOfSpan, curve.pieceOf(breaks.at[from])).transpose();
    slopes.row(row + 1) = frameSlope(curve, truth, to * partsOfSpan, last).transpose();
  }
  const Rows poles = interpolateCubic(breaks, values, slopes);
  Curve result{3, breaks.knots(), {}};
  for (Eigen::Index i = 0; i < poles.rows(); ++i) result.poles.emplace_back(poles.row(i).transpose());
  return result;
}

/// Largest angle in each span.
std::vector<double> frameErrors(const Curve& fitted, const TrueFrames& truth, std::size_t spans) {
  std::vector<double> errors(spans, 0.0);
  for (std::size_t k = 0; k < spans; ++k)
    for (std::size_t i = 1; i < partsOfSpan; ++i) {
      const std::size_t node = k * partsOfSpan + i;
      const Vec4 q = evaluate(fitted, truth.frames.frames[node].at);
      errors[k] = std::max(errors[k], angleBetween(truth.quaternions[node], q));
    }
  return errors;
}

CubicBreaks halvedWhere(const CubicBreaks& breaks, const std::vector<double>& errors, double tolerance) {
  CubicBreaks result;
  for (std::size_t k = 0; k < breaks.at.size(); ++k) {
    result.at.push_back(breaks.at[k]);
    result.multiplicity.push_back(breaks.multiplicity[k]);
    if (k + 1 == breaks.at.size() || errors[k] <= tolerance) continue;
    result.at.push_back((breaks.at[k] + breaks.at[k + 1]) / 2);
    result.multiplicity.push_back(1);
  }
  return result;
}

}  // namespace

FrameSpline fitFrames(const SmoothCurve& curve, const FrameSplineOptions& options, const Progress& progress) {
  CubicBreaks breaks = firstFrameBreaks(curve, std::max<std::size_t>(options.spans, 1));
  FrameSpline result;
  result.coarse = breaks.at;
  while (true) {
    const TrueFrames truth = trueFrames(curve, breaks, options, progress);
    result.quaternions = interpolateFrames(curve, breaks, truth);
    const std::size_t spans = breaks.at.size() - 1;
    const std::vector<double> errors = frameErrors(result.quaternions, truth, spans);
    const auto worst = std::max_element(errors.begin(), errors.end());
    result.deviation = *worst + truth.frames.uncertainty;
    result.closing = truth.frames.closing;
    result.spans = spans;
    if (result.deviation <= options.tolerance) return result;
    CubicBreaks finer = halvedWhere(breaks, errors, options.tolerance - truth.frames.uncertainty);
    if (finer.at.size() > std::max(options.maximumSpans, 4 * result.coarse.size()))
      throw Error(ErrorCode::LimitExceeded,
                  fmt::format("With {} spans the frames still deviate by {:.3g} degrees near v = {:.6g}.", spans,
                              toDegrees(result.deviation), breaks.at[static_cast<std::size_t>(worst - errors.begin())]),
                  "Ask for a larger tolerance, or smooth the curve there.");
    breaks = std::move(finer);
  }
}

}  // namespace blossom::sweep
