#pragma once
#include <cstddef>
#include <vector>

#include "geometry/bspline/surface.h"
#include "kernel/basis_table.h"

namespace blossom::sweep {

/// Number of parameters processed together; the twelve arrays of a block fit into the first-level cache.
inline constexpr std::size_t blockSize = 64;

/// One block of a factor: its four components with their u and v derivatives, along v.
struct FactorBlock {
  alignas(64) double value[4][blockSize];
  alignas(64) double du[4][blockSize];
  alignas(64) double dv[4][blockSize];
};

/// A tensor-product factor prepared for evaluation on a grid: the sums over the v basis are computed once for every row of
/// poles, so that each point only needs the sum over degreeU + 1 rows. Memory: 8 doubles per pole row and v parameter.
class FactorGrid {
 public:
  /// @param u,v tables made with the knots of `surface`
  FactorGrid(const Surface& surface, BasisTable u, const BasisTable& v);

  [[nodiscard]] std::size_t countU() const { return u_.size(); }
  [[nodiscard]] std::size_t countV() const { return countV_; }
  [[nodiscard]] int degreeU() const { return u_.degree; }
  [[nodiscard]] const double* basisU(std::size_t k) const { return u_.values(k).data(); }
  [[nodiscard]] const double* basisDerivativesU(std::size_t k) const { return u_.derivatives(k).data(); }
  /// The first row needed for u parameter k. Rows are consecutive; each consists of the four components and their v
  /// derivatives as eight arrays of stride() values.
  [[nodiscard]] const double* rows(std::size_t k) const { return planes_.data() + (u_.first[k] - firstRow_) * 8 * stride_; }
  [[nodiscard]] std::size_t stride() const { return stride_; }

 private:
  BasisTable u_;
  std::size_t countV_ = 0, stride_ = 0, firstRow_ = 0;
  std::vector<double> planes_;
};

}  // namespace blossom::sweep
