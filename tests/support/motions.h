#pragma once
#include <cmath>
#include <numbers>

#include "geometry/shape/motion.h"
#include "support/splines.h"

/// Random two-parameter motions whose quaternions stay away from zero.
namespace blossom::test {

/// Unit quaternion of a half-angle about z, leaned a little at random, times a random length.
inline Vec4 randomQuaternion(Random& random, double halfAngle) {
  const Vec4 lean(1, uniform(random, -0.3, 0.3), uniform(random, -0.3, 0.3), 0);
  const double c = std::cos(halfAngle), s = std::sin(halfAngle);
  return uniform(random, 0.7, 1.4) * Vec4(c * lean[0], c * lean[1] - s * lean[2], c * lean[2] + s * lean[1], s * lean[0]);
}

inline Vec4 randomScale(Random& random) {
  return {uniform(random, 0.5, 2), uniform(random, 0.5, 2), uniform(random, 0.5, 2), uniform(random, 0.7, 1.4)};
}

/// One period of knots, inner ones double now and then where the degree allows it.
inline std::vector<double> randomPeriod(Random& random, int rows, int degree) {
  std::vector<double> knots{0};
  while (static_cast<int>(knots.size()) < rows) {
    const bool repeat =
        degree > 1 && knots.size() > 1 && uniformInt(random, 0, 4) == 0 && knots.back() != knots[knots.size() - 2];
    knots.push_back(repeat ? knots.back() : knots.back() + uniform(random, 0.5, 1.5));
  }
  const double length = knots.back() + 1;
  for (double& knot : knots) knot /= length;
  knots.push_back(1);
  return knots;
}

/// Degrees 1 to 3 in each direction, or all 3; any inner multiplicity up to the degree.
/// @param period rows of a closed motion; with few of them, basis functions overlap more often than there are rows
inline Motion randomMotion(Random& random, ClosedU closed, bool allCubic = false, int period = 9) {
  const auto degree = [&](int minimum) { return allCubic ? 3 : uniformInt(random, minimum, 3); };
  const KnotChoice clampedKnots{.spans = 5, .clamped = true};
  const auto clampedVector = [&](int p) {
    std::vector<double> knots = randomKnots(random, p, clampedKnots);
    // Clamped or not by chance is for other tests: motions are clamped in v.
    std::fill(knots.begin(), knots.begin() + p, 0.0);
    std::fill(knots.end() - p, knots.end(), 1.0);
    return knots;
  };
  Motion motion;
  motion.closedU = closed;
  motion.point = Vec3(uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, 0.5, 2));
  motion.trajectory.degree = degree(1);
  motion.trajectory.knots = clampedVector(motion.trajectory.degree);
  while (motion.trajectory.poles.size() + static_cast<std::size_t>(motion.trajectory.degree) + 1 <
         motion.trajectory.knots.size())
    motion.trajectory.poles.push_back(randomPole(random, 10));
  const auto surface = [&](double sign, auto pole) {
    const int pu = degree(1), pv = degree(1);
    const std::vector<double> knotsV = clampedVector(pv);
    const std::size_t columns = knotsV.size() - static_cast<std::size_t>(pv) - 1;
    const std::vector<double> knotsU = closed == ClosedU::No ? clampedVector(pu) : randomPeriod(random, period, pu);
    const std::size_t rows = closed == ClosedU::No ? knotsU.size() - static_cast<std::size_t>(pu) - 1 : knotsU.size() - 1;
    std::vector<Vec4> poles;
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j) poles.push_back(pole(static_cast<double>(i) / static_cast<double>(rows)));
    if (closed == ClosedU::No) return Surface{pu, pv, knotsU, knotsV, poles};
    return unwrapped(pu, pv, knotsU, knotsV, poles, sign);
  };
  const double turn = closed == ClosedU::Periodic ? 0 : std::numbers::pi;
  motion.orientation =
      surface(closed == ClosedU::AntiPeriodic ? -1 : 1, [&](double at) { return randomQuaternion(random, turn * at); });
  motion.scaling = surface(1, [&](double) { return randomScale(random); });
  return motion;
}

inline double randomIn(Random& random, std::pair<double, double> domain) {
  return uniform(random, domain.first, domain.second);
}

}  // namespace blossom::test
