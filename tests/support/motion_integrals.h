#pragma once
#include <utility>
#include <vector>

#include "sweep/kernel/grid/motion_grid.h"

namespace blossom::test {

/// Integral over a swept surface of f(point, x_u cross x_v) by Gauss's rule with five nodes in each of parts x parts cells.
template <class F>
double integrate(const Motion& motion, int parts, F f) {
  constexpr double node[5] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831, 0.9061798459386640};
  constexpr double weight[5] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
                                0.2369268850561891};
  const auto nodes = [&](std::pair<double, double> domain) {
    std::vector<double> result;
    const double h = (domain.second - domain.first) / parts;
    for (int i = 0; i < parts; ++i)
      for (const double x : node) result.push_back(domain.first + h * (i + (1 + x) / 2));
    return result;
  };
  const auto us = nodes(motion.domainU()), vs = nodes(motion.domainV());
  sweep::MotionGrid grid;
  sweep::evaluateGrid(motion, us, vs, grid, sweep::GridDerivatives::Yes);
  double sum = 0;
  for (std::size_t k = 0; k < us.size(); ++k)
    for (std::size_t l = 0; l < vs.size(); ++l)
      sum += weight[k % 5] * weight[l % 5] * f(grid.pointAt(k, l), Vec3(grid.duAt(k, l).cross(grid.dvAt(k, l))));
  const auto [u0, u1] = motion.domainU();
  const auto [v0, v1] = motion.domainV();
  return sum * (u1 - u0) * (v1 - v0) / (4.0 * parts * parts);
}

/// Volume that a motion encloses, alone or with ends in planes through the origin, by the divergence theorem; negative where
/// x_u cross x_v points inwards.
inline double volumeEnclosed(const Motion& motion, int parts) {
  return integrate(motion, parts, [](const Vec3& p, const Vec3& n) { return p.dot(n) / 3; });
}

}  // namespace blossom::test
