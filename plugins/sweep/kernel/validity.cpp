#include "kernel/validity.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "kernel/motion_grid.h"

namespace blossom::sweep {

namespace {

/// Eight places in every span between the knots of all factors, and the end of the domain.
std::vector<double> places(std::pair<double, double> domain, std::initializer_list<const std::vector<double>*> factors) {
  std::vector<double> breaks;
  for (const auto* knots : factors)
    for (const double knot : *knots)
      if (knot >= domain.first && knot <= domain.second) breaks.push_back(knot);
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    for (int k = 0; k < 8; ++k) result.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * k / 8);
  result.push_back(breaks.back());
  return result;
}

}  // namespace

Validity examine(const Motion& motion, const Progress& progress) {
  const std::vector<double> us = places(motion.domainU(), {&motion.orientation.knotsU, &motion.scaling.knotsU});
  const std::vector<double> vs =
      places(motion.domainV(), {&motion.orientation.knotsV, &motion.scaling.knotsV, &motion.trajectory.knots});
  MotionGrid grid;
  evaluateGrid(motion, us, vs, grid, GridDerivatives::Yes, progress);
  Validity result;
  double largest = 0;
  for (std::size_t k = 0; k < us.size(); ++k)
    for (std::size_t l = 0; l < vs.size(); ++l) {
      const double length = grid.duAt(k, l).cross(grid.dvAt(k, l)).norm();
      largest = std::max(largest, length);
      if ((k == 0 && l == 0) || length < result.smallestNormal)
        result.smallestNormal = length, result.u = us[k], result.v = vs[l];
    }
  result.smallestShare = largest > 0 ? result.smallestNormal / largest : 0;
  return result;
}

}  // namespace blossom::sweep
