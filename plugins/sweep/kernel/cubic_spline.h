#pragma once
#include <cstddef>
#include <vector>

#include "geometry/numeric/cubic_slopes.h"

namespace blossom::sweep {

/// One row for each break.
using Rows = NumberRows;

/// Where a piecewise cubic function is smooth and where it may bend. C2 at breaks of multiplicity 1, C1 at 2, C0 at 3.
struct CubicBreaks {
  std::vector<double> at;         ///< increasing
  std::vector<int> multiplicity;  ///< one per break, 1 to 3; those of the ends do not count
  bool periodic = false;          ///< the ends are one C2 break; only with multiplicity 1 everywhere

  /// Breaks between which the spline is C2: index pairs [from, to]. None when periodic.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> segments() const;
  /// Full clamped knot vector of degree 3.
  [[nodiscard]] std::vector<double> knots() const;
};

/// Poles of the cubic B-splines that pass through `values` (one row for each break) and have the derivatives `slopes` at
/// both ends of every segment (rows 2k and 2k+1 for segment k; none when periodic). The ends of a periodic spline give
/// identical poles. O(rows * columns).
Rows interpolateCubic(const CubicBreaks&, const Rows& values, const Rows& slopes);

}  // namespace blossom::sweep
