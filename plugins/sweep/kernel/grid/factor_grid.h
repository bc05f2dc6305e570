#pragma once
#include <cstddef>
#include <vector>

#include "geometry/bspline/surface.h"
#include "kernel/grid/basis_table.h"
#include "kernel/grid/grid_range.h"

namespace blossom::sweep {

/// A tensor-product factor prepared for evaluation on a grid: the sums over the v basis are computed once for every row of
/// poles, so that each point only needs the sum over degreeU + 1 rows. Memory: 8 doubles per pole row and v parameter.
class FactorGrid {
 public:
  FactorGrid() = default;
  /// @param u,v tables made with the knots of `surface`
  FactorGrid(const Surface& surface, BasisTable u, BasisTable v);

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

 private:
  BasisTable u_, v_;
  std::size_t stride_ = 0, firstRow_ = 0, rowCount_ = 0;
  std::vector<double> planes_;
};

}  // namespace blossom::sweep
