#include <cmath>
#include <numbers>

#include "kernel/begin/motion_from_curve.h"
#include "samples.h"

namespace blossom::sweep::samples {

namespace {

constexpr double turns = 1.75, growth = 0.2, firstRadius = 7, slope = 0.55, girth = 0.36;

/// Distance from the axis after a part of the way.
double spiralRadius(double part) { return firstRadius * std::exp(growth * 2 * std::numbers::pi * turns * part); }

Curve spiral() {
  Curve curve{3, clampedKnots(3, evenBreaks(14)), {}};
  for (const double part : grevilleAbscissae(3, curve.knots)) {
    const double angle = 2 * std::numbers::pi * turns * part, radius = spiralRadius(part);
    curve.poles.emplace_back(radius * std::cos(angle), radius * std::sin(angle), -slope * radius, 1);
  }
  return curve;
}

}  // namespace

Motion horn() {
  Motion motion =
      motionFromCurve(spiral(), {.radius = 1, .tolerance = 1e-4, .rows = 12, .columns = 14, .normal = Vec3::UnitZ()}).motion;
  Surface& scaling = motion.scaling;
  const std::vector<double> along = grevilleAbscissae(scaling.degreeV, scaling.knotsV);
  for (std::size_t i = 0; i < scaling.countU(); ++i)
    for (std::size_t j = 0; j < scaling.countV(); ++j) scaling.pole(i, j)[0] = girth * spiralRadius(along[j]);
  return motion;
}

}  // namespace blossom::sweep::samples
