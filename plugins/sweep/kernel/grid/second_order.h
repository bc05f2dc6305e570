#pragma once
#include <cstddef>
#include <vector>

#include "geometry/bspline/surface.h"
#include "kernel/grid/basis_table.h"
#include "kernel/grid/vector_width.h"

namespace blossom::sweep {

/// Number of parameters v whose second-order derivatives are processed together.
inline constexpr std::size_t jetCount = 32;

/// One block of a factor: its four components with all derivatives up to the second order, along v.
struct FactorJets {
  enum Part { Value, U, V, UU, UV, VV };
  alignas(64) double part[6][4][jetCount];
};

/// A factor prepared for second derivatives on a grid, as FactorGrid is for first ones. Memory: 12 doubles per pole row and
/// v parameter.
class SecondOrderGrid {
 public:
  SecondOrderGrid(const Surface& surface, std::span<const double> us, std::span<const double> vs);

  /// Derivatives at u parameter k and v parameters begin .. begin + count - 1; count is at most jetCount.
  void evaluate(std::size_t k, std::size_t begin, std::size_t count, FactorJets& out) const;

 private:
  BasisTable u_;
  std::size_t stride_ = 0;
  std::vector<double> planes_;  ///< for each row of poles, order of the v derivative and component, one array along v
};

}  // namespace blossom::sweep
