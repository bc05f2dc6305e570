#pragma once
#include "geometry/shape/motion.h"
#include "support/splines.h"

/// Random curves with a tangent everywhere.
namespace blossom::test {

/// A cubic or quintic with simple knots whose poles advance along x, so that it cannot stand still; weights now and then.
inline Curve randomPath(Random& random, double size = 40) {
  Curve curve;
  curve.degree = uniformInt(random, 1, 2) * 2 + 1;
  const int spans = uniformInt(random, 1, 5);
  curve.knots.assign(static_cast<std::size_t>(curve.degree) + 1, 0.0);
  for (int i = 1; i < spans; ++i) curve.knots.push_back((i + uniform(random, -0.3, 0.3)) / spans);
  curve.knots.insert(curve.knots.end(), static_cast<std::size_t>(curve.degree) + 1, 1.0);
  const std::size_t count = curve.knots.size() - static_cast<std::size_t>(curve.degree) - 1;
  const bool rational = uniformInt(random, 0, 2) == 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double w = rational ? uniform(random, 0.8, 1.25) : 1;
    const double x = size * (static_cast<double>(i) + uniform(random, -0.2, 0.2)) / static_cast<double>(count - 1);
    const double y = uniform(random, -0.3, 0.3) * size, z = uniform(random, -0.3, 0.3) * size;
    curve.poles.emplace_back(w * x, w * y, w * z, w);
  }
  return curve;
}

/// A closed cubic around z, unclamped, with hills.
inline Curve randomRing(Random& random, double size = 40) {
  const int n = uniformInt(random, 7, 12);
  std::vector<double> period;
  for (int i = 0; i <= n; ++i) period.push_back(static_cast<double>(i) / n);
  Curve curve{3, unwrappedKnots(3, period), {}};
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n, radius = size * uniform(random, 0.7, 1.2);
    curve.poles.emplace_back(radius * std::cos(angle), radius * std::sin(angle), size * uniform(random, -0.4, 0.4), 1);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec4 pole = curve.poles[i];
    curve.poles.push_back(pole);
  }
  return curve;
}

}  // namespace blossom::test
