#include "samples.h"

#include <cmath>
#include <numbers>

#include "geometry/bspline/bspline.h"
#include "kernel/quaternion.h"

namespace blossom::sweep::samples {

using std::numbers::pi;

Curve straight(int degree, const std::vector<double>& knots, const Vec3& from, const Vec3& to) {
  Curve curve{degree, knots, {}};
  const auto [first, last] = curve.knots.empty() ? std::pair{0.0, 1.0} : std::pair{knots.front(), knots.back()};
  for (const double at : grevilleAbscissae(degree, knots)) {
    const Vec3 p = from + (to - from) * ((at - first) / (last - first));
    curve.poles.emplace_back(p.x(), p.y(), p.z(), 1);
  }
  return curve;
}

Motion cylinder() {
  const std::vector<double> knotsV = clampedKnots(3, evenBreaks(4));
  const auto orientation = [](double angle, double) { return rotationAbout(Vec3::UnitZ(), angle); };
  const auto scaling = [](double, double) { return Vec4(10, 10, 10, 1); };
  return {straight(3, knotsV, Vec3::Zero(), {0, 0, 40}), closedBicubic(8, knotsV, -1, orientation),
          closedBicubic(8, knotsV, 1, scaling), ClosedU::AntiPeriodic, Vec3::UnitX()};
}

namespace {

/// Cubic spline around the origin, the half-angle running from 0 to `halfAngle` over `spans` even spans, clamped. Whatever
/// its distance from the origin, the rotation it stands for moves points on exact circles.
Curve halfAngleCurve(std::size_t spans, double halfAngle) {
  Curve curve{3, {}, {}};
  for (int i = -3; i <= static_cast<int>(spans) + 3; ++i) curve.knots.push_back(i / static_cast<double>(spans));
  for (int i = 0; i < static_cast<int>(spans) + 3; ++i) {
    const double angle = halfAngle * (i - 1) / static_cast<double>(spans);
    curve.poles.emplace_back(std::cos(angle), 0, 0, std::sin(angle));
  }
  return clamped(curve);
}

}  // namespace

Motion torus() {
  const std::size_t spans = 8;
  const Curve big = halfAngleCurve(spans, pi);
  std::vector<Vec4> quaternions, ones;
  for (std::size_t i = 0; i < spans; ++i) {
    const Vec4 small = rotationAbout(-Vec3::UnitY(), 2 * pi * (static_cast<double>(i) - 1) / static_cast<double>(spans));
    for (const Vec4& pole : big.poles) quaternions.push_back(times(pole, small));
    ones.insert(ones.end(), 2, Vec4(10, 10, 10, 1));
  }
  return {circleInStep(big, 30), unwrapped(3, 3, evenBreaks(spans), big.knots, quaternions, -1),
          unwrapped(3, 1, evenBreaks(spans), {0, 0, 1, 1}, ones, 1), ClosedU::AntiPeriodic, Vec3::UnitX()};
}

Motion helicoid() {
  const Curve turns = halfAngleCurve(32, 2 * pi);
  Surface orientation{1, 3, {0, 0, 1, 1}, turns.knots, turns.poles};
  orientation.poles.insert(orientation.poles.end(), turns.poles.begin(), turns.poles.end());
  const Surface scaling{1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 1, 1, 1}, {0, 1, 1, 1}, {25, 1, 1, 1}, {25, 1, 1, 1}}};
  return {straight(1, {0, 0, 1, 1}, Vec3::Zero(), {0, 0, 40}), orientation, scaling, ClosedU::No, Vec3::UnitX()};
}

Motion twistedTube() {
  const std::size_t spans = 24;
  const double bend = 2 * pi / 3, radius = 45;
  const std::vector<double> knotsV = clampedKnots(3, evenBreaks(10));
  Curve trajectory{3, knotsV, {}};
  for (const double v : grevilleAbscissae(3, knotsV))
    trajectory.poles.emplace_back(radius * (1 - std::cos(bend * v)), 0, radius * std::sin(bend * v), 1);
  const auto orientation = [&](double angle, double v) {
    return times(rotationAbout(Vec3::UnitY(), bend * v), rotationAbout(Vec3::UnitZ(), angle + pi * v));
  };
  const auto scaling = [&](double angle, double v) {
    const double s = (10 - 3 * v) * (1 + 0.32 * std::cos(3 * angle));
    return Vec4(s, s, s, 1);
  };
  return {trajectory, closedBicubic(spans, knotsV, -1, orientation), closedBicubic(spans, knotsV, 1, scaling),
          ClosedU::AntiPeriodic, Vec3::UnitX()};
}

}  // namespace blossom::sweep::samples
