#include "kernel/begin/rotation_minimizing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace blossom::sweep {

namespace {

/// Smaller steps would gain nothing over rounding.
constexpr int maximumFrameHalvings = 26;
/// Radians that rounding takes in one step.
constexpr double frameRounding = 4e-16;

/// Signed angle from a to b about an axis of unit length to which both are perpendicular.
double signedAngle(const Vec3& a, const Vec3& b, const Vec3& axis) { return std::atan2(axis.dot(a.cross(b)), a.dot(b)); }

CurveFrame firstFrame(const SmoothCurve& curve, double at, const Vec3& wanted) {
  const CurvePoint start = curve.at(at);
  const Vec3 tangent = start.tangent();
  Vec3 direction = wanted;
  if (direction.isZero(0)) direction = std::abs(tangent.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
  const Vec3 across = direction.normalized() - tangent.dot(direction.normalized()) * tangent;
  if (!(across.norm() > 1e-6))
    throw Error(ErrorCode::InvalidParameter, "The start normal points along the curve.",
                "Give a direction that stands across the start of the curve.");
  Vec3 normal = across.normalized();
  normal = (normal - tangent.dot(normal) * tangent).normalized();
  return {at, start.point, tangent, normal};
}

/// Carries one frame along a curve.
class FrameCarrier {
 public:
  FrameCarrier(const SmoothCurve& curve, double accuracy, const Progress& progress)
      : curve_(curve), accuracy_(accuracy), progress_(progress) {}

  [[nodiscard]] double uncertainty() const { return uncertainty_; }

  CurveFrame carry(const CurveFrame& from, double to, int halvings = 0) {
    if (to == from.at) return from;
    progress_.check();
    const CurvePoint end = curve_.at(to);
    const double middle = from.at + (to - from.at) / 2;
    if (halvings < maximumFrameHalvings && !isTame(from, end)) return carryHalves(from, middle, to, halvings);
    CurveFrame whole = stepped(from, end, to);
    if (accuracy_ == 0) return whole;
    const CurveFrame half = stepped(from, curve_.at(middle), middle);
    CurveFrame fine = stepped(half, end, to);
    // With an error of C h^5, two half steps keep 1/16 of it and differ from the whole step by 15/16.
    const double error = std::abs(signedAngle(whole.normal, fine.normal, fine.tangent)) / 15;
    if (error <= std::max(accuracy_ * (to - from.at), frameRounding)) {
      uncertainty_ += error;
      return fine;
    }
    if (halvings == maximumFrameHalvings)
      throw Error(ErrorCode::LimitExceeded,
                  fmt::format("The frames cannot be computed near v = {:.6g}: the curve turns too fast there.", from.at),
                  "Smooth the curve there.");
    return carryHalves(from, middle, to, halvings);
  }

 private:
  CurveFrame carryHalves(const CurveFrame& from, double middle, double to, int halvings) {
    return carry(carry(from, middle, halvings + 1), to, halvings + 1);
  }

  static CurveFrame stepped(const CurveFrame& from, const CurvePoint& end, double to) {
    CurveFrame frame = doubleReflection(from, end);
    frame.at = to;
    return frame;
  }

  /// Chord and tangents within a right angle: neither of the two mirrors is undefined.
  static bool isTame(const CurveFrame& from, const CurvePoint& end) {
    const Vec3 chord = end.point - from.point;
    return from.tangent.dot(end.first) > 0 && chord.dot(from.tangent) > 0 && chord.dot(end.first) > 0;
  }

  const SmoothCurve& curve_;
  double accuracy_;
  const Progress& progress_;
  double uncertainty_ = 0;
};

void distributeClosing(const SmoothCurve& curve, FrameResult& result) {
  std::vector<CurveFrame>& frames = result.frames;
  const Vec3 axis = frames.front().tangent;
  result.closing = signedAngle(frames.back().normal, frames.front().normal, axis);
  std::vector<double> way{0};
  for (std::size_t i = 1; i < frames.size(); ++i) way.push_back(way.back() + curve.length(frames[i - 1].at, frames[i].at));
  result.length = way.back();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Eigen::AngleAxisd turn(result.closing * way[i] / way.back(), frames[i].tangent);
    frames[i].normal = turn * frames[i].normal;
  }
  frames.back().normal = frames.front().normal;
}

}  // namespace

CurveFrame doubleReflection(const CurveFrame& from, const CurvePoint& to) {
  const Vec3 tangent = to.tangent(), v1 = to.point - from.point;
  const auto mirrored = [](const Vec3& a, const Vec3& v) -> Vec3 {
    const double square = v.squaredNorm();
    return square > 0 ? Vec3(a - 2 / square * v.dot(a) * v) : a;
  };
  const Vec3 v2 = tangent - mirrored(from.tangent, v1);
  Vec3 normal = mirrored(mirrored(from.normal, v1), v2);
  // Rounding must not add up over many steps.
  normal = (normal - tangent.dot(normal) * tangent).normalized();
  return {0, to.point, tangent, normal};
}

FrameResult rotationMinimizingFrames(const SmoothCurve& curve, std::span<const double> at, const FrameOptions& options,
                                     const Progress& progress) {
  if (at.empty() || !std::is_sorted(at.begin(), at.end()))
    throw Error(ErrorCode::InvalidParameter, "The parameters of the frames are not in increasing order.");
  FrameCarrier carrier(curve, options.accuracy, progress);
  FrameResult result;
  result.frames.push_back(firstFrame(curve, at.front(), options.normal));
  for (std::size_t i = 1; i < at.size(); ++i) result.frames.push_back(carrier.carry(result.frames.back(), at[i]));
  result.uncertainty = carrier.uncertainty();
  if (curve.closed() && at.front() == 0 && at.back() == 1) distributeClosing(curve, result);
  return result;
}

}  // namespace blossom::sweep
