#include <cmath>
#include <numbers>

#include "geometry/bspline/bspline.h"
#include "kernel/quaternion.h"
#include "samples.h"

namespace blossom::sweep::samples {

namespace {

constexpr std::size_t spansAround = 12, spansAlong = 6;
constexpr double reach = 16, length = 96, sway = 14, lean = 0.7;

/// A gentle S in the plane y = 0.
Vec3 onTheWay(double v) { return {length * v, 0, sway * std::sin(2 * std::numbers::pi * v)}; }

/// Angle of the way above the x axis.
double climb(double v) { return std::atan2(sway * 2 * std::numbers::pi * std::cos(2 * std::numbers::pi * v), length); }

}  // namespace

Motion sweptPoint() {
  const std::vector<double> knotsV = clampedKnots(3, evenBreaks(spansAlong));
  Curve trajectory{3, knotsV, {}};
  for (const double v : grevilleAbscissae(3, knotsV)) {
    const Vec3 p = onTheWay(v);
    trajectory.poles.emplace_back(p.x(), p.y(), p.z(), 1);
  }
  // Once about the tangent; the farther along, the more the z axis leans to and fro on its way around.
  const auto orientation = [](double angle, double v) {
    const Vec4 along = rotationAbout(-Vec3::UnitY(), climb(v)), around = rotationAbout(Vec3::UnitX(), angle);
    return times(times(along, around), rotationAbout(Vec3::UnitY(), lean * v * std::sin(2 * angle)));
  };
  const auto scaling = [](double, double) { return Vec4(reach, reach, reach, 1); };
  return {trajectory, closedBicubic(spansAround, knotsV, -1, orientation), closedBicubic(spansAround, knotsV, 1, scaling),
          ClosedU::AntiPeriodic, Vec3::UnitZ()};
}

}  // namespace blossom::sweep::samples
