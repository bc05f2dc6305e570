#include "kernel/grid/basis_table.h"

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

GridRange BasisTable::support(const GridRange& poles) const {
  if (poles.empty()) return {};
  const std::size_t reach = static_cast<std::size_t>(degree);
  const auto begin =
      std::partition_point(first.begin(), first.end(), [&](std::size_t f) { return f + reach < poles.begin; });
  const auto end = std::partition_point(begin, first.end(), [&](std::size_t f) { return f < poles.end; });
  return {static_cast<std::size_t>(begin - first.begin()), static_cast<std::size_t>(end - first.begin())};
}

BasisTable tabulateBasis(int degree, std::span<const double> knots, std::span<const double> parameters, KnotSide side,
                         int order) {
  const std::size_t width = static_cast<std::size_t>(degree) + 1;
  BasisTable table;
  table.degree = degree;
  table.first.reserve(parameters.size());
  std::vector<double>* const parts[3] = {&table.value, &table.derivative, &table.second};
  for (int d = 0; d <= order; ++d) parts[d]->resize(parameters.size() * width);
  std::vector<double> all((static_cast<std::size_t>(order) + 1) * width);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    std::size_t span = findSpan(degree, knots, parameters[k]);
    if (side == KnotSide::Left && knots[span] == parameters[k]) span = spanEndingAt(degree, knots, span, parameters[k]);
    basisDerivatives(degree, knots, span, parameters[k], order, all);
    table.first.push_back(span - static_cast<std::size_t>(degree));
    for (int d = 0; d <= order; ++d)
      std::copy_n(all.data() + static_cast<std::size_t>(d) * width, width, parts[d]->data() + k * width);
  }
  return table;
}

}  // namespace blossom::sweep
