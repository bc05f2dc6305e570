#include "manipulators/factors/factor_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/angle.h"
#include "kernel/edit/motion_symmetry.h"

namespace blossom::sweep {

namespace {

/// The mean of the inner knots of a pole, near which it has the most influence.
double grevilleOf(const std::vector<double>& knots, int degree, std::size_t pole) {
  const auto first = knots.begin() + static_cast<std::ptrdiff_t>(pole) + 1;
  return std::accumulate(first, first + degree, 0.0) / degree;
}

std::vector<double> differentKnots(const std::vector<double>& knots, std::pair<double, double> domain) {
  std::vector<double> different;
  for (const double knot : knots)
    if (knot >= domain.first && knot <= domain.second && (different.empty() || knot > different.back()))
      different.push_back(knot);
  return different;
}

std::pair<double, double> supportOf(const std::vector<double>& knots, int degree, std::size_t pole) {
  return {knots[pole], knots[pole + static_cast<std::size_t>(degree) + 1]};
}

void layColumns(const std::vector<double>& knots, int degree, std::size_t count, FactorLayout& layout) {
  for (std::size_t j = 0; j < count; ++j) {
    layout.vs.push_back(std::clamp(grevilleOf(knots, degree, j), layout.domainV.first, layout.domainV.second));
    layout.reachV.push_back(supportOf(knots, degree, j));
  }
  layout.knotsV = differentKnots(knots, layout.domainV);
}

void layRows(const Motion& motion, const Surface& factor, FactorLayout& layout) {
  for (std::size_t i = 0; i < freeRows(motion, factor); ++i) {
    const double u = insidePeriod(motion, grevilleOf(factor.knotsU, factor.degreeU, i));
    layout.us.push_back(std::clamp(u, layout.domainU.first, layout.domainU.second));
    layout.reachU.push_back(supportOf(factor.knotsU, factor.degreeU, i));
  }
  layout.knotsU = differentKnots(factor.knotsU, layout.domainU);
}

}  // namespace

EditRegion FactorLayout::region(const FactorPole& pole) const {
  const auto [u0, u1] = reachU[pole.row];
  const auto [v0, v1] = reachV[pole.column];
  const bool around = factor == Factor::Trajectory || (closed && u1 - u0 >= domainU.second - domainU.first);
  return {u0, u1, v0, v1, around};
}

FactorLayout layoutOf(const Motion& motion, Factor factor) {
  FactorLayout layout;
  layout.factor = factor;
  layout.closed = motion.closedU != ClosedU::No;
  layout.domainU = motion.domainU();
  layout.domainV = motion.domainV();
  if (factor == Factor::Trajectory) {
    layout.us = {(layout.domainU.first + layout.domainU.second) / 2};
    layout.reachU = {layout.domainU};
    layColumns(motion.trajectory.knots, motion.trajectory.degree, motion.trajectory.poles.size(), layout);
    return layout;
  }
  const Surface& surface = factor == Factor::Orientation ? motion.orientation : motion.scaling;
  layRows(motion, surface, layout);
  layColumns(surface.knotsV, surface.degreeV, surface.countV(), layout);
  return layout;
}

PoleValue poleValue(const Motion& motion, Factor factor, const FactorPole& pole) {
  const Vec4& h = factor == Factor::Trajectory    ? motion.trajectory.poles[pole.column]
                  : factor == Factor::Orientation ? motion.orientation.pole(pole.row, pole.column)
                                                  : motion.scaling.pole(pole.row, pole.column);
  if (factor == Factor::Orientation) return {Vec3::Zero(), h.norm()};
  return {h.head<3>() / h[3], h[3]};
}

double poleAngle(const Motion& motion, const FactorPole& pole) {
  const Vec4& q = motion.orientation.pole(pole.row, pole.column);
  return 2 * toDegrees(std::atan2(q.tail<3>().norm(), q[0]));
}

}  // namespace blossom::sweep
