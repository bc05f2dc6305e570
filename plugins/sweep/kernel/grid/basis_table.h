#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "kernel/grid/grid_range.h"

namespace blossom::sweep {

/// The polynomial piece evaluated at a knot.
enum class KnotSide { Left, Right };

/// The non-zero basis functions and their derivatives at many parameters.
struct BasisTable {
  int degree = 0;
  std::vector<std::size_t> first;  ///< index of the first pole with a non-zero basis function, one per parameter
  std::vector<double> value;       ///< degree + 1 for each parameter
  std::vector<double> derivative;  ///< degree + 1 for each parameter
  std::vector<double> second;      ///< second derivatives, degree + 1 for each parameter; only when they were asked for

  [[nodiscard]] std::size_t size() const { return first.size(); }
  [[nodiscard]] std::span<const double> values(std::size_t k) const { return row(value, k); }
  [[nodiscard]] std::span<const double> derivatives(std::size_t k) const { return row(derivative, k); }
  [[nodiscard]] std::span<const double> seconds(std::size_t k) const { return row(second, k); }

  /// The parameters at which one of the poles of a range has a basis function that is not zero. The parameters must ascend.
  /// O(log parameters).
  [[nodiscard]] GridRange support(const GridRange& poles) const;

 private:
  [[nodiscard]] std::span<const double> row(const std::vector<double>& from, std::size_t k) const {
    const std::size_t order = static_cast<std::size_t>(degree) + 1;
    return std::span(from).subspan(k * order, order);
  }
};

/// @param knots full vector, clamped or not  @param parameters inside the domain  @param order of the highest derivatives, 1
/// or 2. O(parameters * degree^2).
BasisTable tabulateBasis(int degree, std::span<const double> knots, std::span<const double> parameters,
                         KnotSide side = KnotSide::Right, int order = 1);

}  // namespace blossom::sweep
