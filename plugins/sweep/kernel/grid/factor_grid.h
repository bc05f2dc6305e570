#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/bspline/surface.h"
#include "kernel/grid/basis_table.h"
#include "kernel/grid/grid_range.h"

namespace blossom::sweep {

/// The basis functions of a cubic factor over one span of knots, as powers of the distance from its middle: the coefficient
/// of a power is a combination of four rows of poles. Value and derivative then take 5 multiplications instead of 8, and
/// the v derivative 3 instead of 4, which pays where many parameters of a grid lie in the span.
struct CubicSpan {
  double middle = 0;
  double weights[4][4];  ///< of the rows, for each power
};

/// A tensor-product factor prepared for evaluation on a grid: the sums over the v basis are computed once for every row of
/// poles, so that each point only needs the sum over degreeU + 1 rows. Memory: 8 doubles per pole row and v parameter.
class FactorGrid {
 public:
  FactorGrid() = default;
  /// @param us the parameters of the table u  @param u,v tables made with the knots of `surface`
  FactorGrid(const Surface& surface, std::span<const double> us, BasisTable u, BasisTable v);

  /// Sums one row of poles anew where its poles in the range `poles` have changed. O(degreeV) per column of their support.
  void updateRow(const Surface& surface, std::size_t row, const GridRange& poles);

  [[nodiscard]] const BasisTable& u() const { return u_; }
  [[nodiscard]] const BasisTable& v() const { return v_; }
  [[nodiscard]] int degreeU() const { return u_.degree; }
  [[nodiscard]] const double* basisU(std::size_t k) const { return u_.values(k).data(); }
  [[nodiscard]] const double* basisDerivativesU(std::size_t k) const { return u_.derivatives(k).data(); }
  /// The first row needed for u parameter k. Rows are consecutive; each consists of the four components and their v
  /// derivatives as eight arrays of stride() values.
  [[nodiscard]] const double* rows(std::size_t k) const { return planes_.data() + (u_.first[k] - firstRow_) * 8 * stride_; }
  [[nodiscard]] std::size_t stride() const { return stride_; }
  /// The span of u parameter k; nullptr where its basis functions are to be used. The choice depends on the parameters of
  /// the grid alone, so that a place has the same result whatever is evaluated with it.
  [[nodiscard]] const CubicSpan* span(std::size_t k) const {
    return spanOf_[k] < 0 ? nullptr : &spans_[static_cast<std::size_t>(spanOf_[k])];
  }
  [[nodiscard]] double fromMiddle(std::size_t k) const { return fromMiddle_[k]; }

 private:
  void findSpans(const Surface&, std::span<const double> us);

  BasisTable u_, v_;
  std::size_t stride_ = 0, firstRow_ = 0, rowCount_ = 0;
  std::vector<double> planes_;
  std::vector<CubicSpan> spans_;
  std::vector<int> spanOf_;  ///< of each u parameter; -1: none
  std::vector<double> fromMiddle_;
};

}  // namespace blossom::sweep
