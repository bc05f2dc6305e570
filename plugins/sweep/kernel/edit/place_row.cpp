#include "kernel/edit/place_row.h"

#include <cmath>

#include "kernel/grid/basis_table.h"

namespace blossom::sweep {

namespace {

/// Changes would have to be a million times as large as what they are to do, and rounding with them.
constexpr double smallestShare = 1e-6;

double squareOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return sum;
}

/// The shares of the free rows, with the sign of the periods passed.
std::vector<double> sharesOfRows(const BasisTable& basis, std::size_t free, double closure) {
  std::vector<double> shares(free, 0.0);
  for (std::size_t i = 0; i < basis.value.size(); ++i) {
    std::size_t row = basis.first[0] + i;
    double share = basis.value[i];
    for (; row >= free; row -= free) share *= closure;
    shares[row] += share;
  }
  return shares;
}

}  // namespace

double closureOfOrientation(const Motion& motion) {
  return motion.closedU == ClosedU::No ? 0 : motion.closedU == ClosedU::AntiPeriodic ? -1 : 1;
}

double closureOfScaling(const Motion& motion) { return motion.closedU == ClosedU::No ? 0 : 1; }

PlaceRow placeRow(const Curve& trajectory, double v) {
  const BasisTable basis = tabulateBasis(trajectory.degree, trajectory.knots, {&v, 1});
  PlaceRow row;
  double weight = 0;
  for (std::size_t j = 0; j < basis.value.size(); ++j) {
    const double share = basis.value[j] * trajectory.poles[basis.first[0] + j][3];
    weight += share;
    if (share == 0) continue;
    row.pole.push_back(basis.first[0] + j);
    row.share.push_back(share);
  }
  for (double& share : row.share) share /= weight;
  return row;
}

PlaceRow placeRow(const Surface& surface, const MotionPlace& place, double closure) {
  const BasisTable bu = tabulateBasis(surface.degreeU, surface.knotsU, {&place.u, 1}),
                   bv = tabulateBasis(surface.degreeV, surface.knotsV, {&place.v, 1});
  const std::size_t free = surface.countU() - (closure == 0 ? 0 : static_cast<std::size_t>(surface.degreeU));
  const std::vector<double> rows = sharesOfRows(bu, free, closure);
  PlaceRow row;
  row.cancelled = squareOf(rows) < smallestShare * smallestShare * squareOf(bu.value);
  for (std::size_t i = 0; !row.cancelled && i < free; ++i)
    for (std::size_t j = 0; rows[i] != 0 && j < bv.value.size(); ++j) {
      if (bv.value[j] == 0) continue;
      row.pole.push_back(i * surface.countV() + bv.first[0] + j);
      row.share.push_back(rows[i] * bv.value[j]);
    }
  return row;
}

}  // namespace blossom::sweep
