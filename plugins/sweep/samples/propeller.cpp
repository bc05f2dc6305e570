#include <cmath>
#include <numbers>

#include "kernel/edit/direct_manipulation.h"
#include "kernel/quaternion.h"
#include "samples.h"

namespace blossom::sweep::samples {

namespace {

constexpr double hubRadius = 10, hubHeight = 36, tipRadius = 62, pitch = 62;
constexpr std::size_t spansU = 16;

/// The hub: a cylinder with knots close together where the blades will grow.
Motion hub() {
  const std::vector<double> knotsV = clampedKnots(3, {0, 0.14, 0.26, 0.36, 0.43, 0.5, 0.57, 0.64, 0.74, 0.86, 1});
  const auto orientation = [](double angle, double) { return rotationAbout(Vec3::UnitZ(), angle); };
  const auto scaling = [](double, double) { return Vec4(hubRadius, hubRadius, hubRadius, 1); };
  return {straight(3, knotsV, {0, 0, -hubHeight / 2}, {0, 0, hubHeight / 2}), closedBicubic(spansU, knotsV, -1, orientation),
          closedBicubic(spansU, knotsV, 1, scaling), ClosedU::AntiPeriodic, Vec3::UnitX()};
}

}  // namespace

Motion propeller() {
  Motion motion = hub();
  for (int blade = 0; blade < 4; ++blade) {
    const double u = (4 * blade + 2) / 16.0, angle = 2 * std::numbers::pi * u;
    const Vec3 outward(std::cos(angle), std::sin(angle), 0);
    dragScaling(motion, u, 0.5, tipRadius * outward);
    twistOrientation(motion, u, 0.5, outward, pitch);
  }
  return motion;
}

}  // namespace blossom::sweep::samples
