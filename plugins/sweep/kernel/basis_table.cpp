#include "kernel/basis_table.h"

#include <algorithm>

#include "geometry/bspline/bspline.h"

namespace blossom::sweep {

namespace {

/// The last non-empty span that ends at t, for the derivative from the left.
std::size_t spanEndingAt(int degree, std::span<const double> knots, std::size_t span, double t) {
  std::size_t left = span;
  while (left > static_cast<std::size_t>(degree) && knots[left] >= t) --left;
  return knots[left] < t ? left : span;
}

}  // namespace

BasisTable tabulateBasis(int degree, std::span<const double> knots, std::span<const double> parameters, KnotSide side) {
  const std::size_t order = static_cast<std::size_t>(degree) + 1;
  BasisTable table;
  table.degree = degree;
  table.first.reserve(parameters.size());
  table.value.resize(parameters.size() * order);
  table.derivative.resize(parameters.size() * order);
  std::vector<double> both(2 * order);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    std::size_t span = findSpan(degree, knots, parameters[k]);
    if (side == KnotSide::Left && knots[span] == parameters[k]) span = spanEndingAt(degree, knots, span, parameters[k]);
    basisDerivatives(degree, knots, span, parameters[k], 1, both);
    table.first.push_back(span - static_cast<std::size_t>(degree));
    std::copy_n(both.begin(), order, table.value.begin() + static_cast<std::ptrdiff_t>(k * order));
    std::copy_n(both.begin() + static_cast<std::ptrdiff_t>(order), order,
                table.derivative.begin() + static_cast<std::ptrdiff_t>(k * order));
  }
  return table;
}

}  // namespace blossom::sweep
