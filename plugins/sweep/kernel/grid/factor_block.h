#pragma once
#include <cstddef>

#include "kernel/grid/factor_grid.h"
#include "kernel/grid/grid_rows.h"
#include "kernel/grid/vector_width.h"

namespace blossom::sweep {

/// One block of a factor: its four components with their u and v derivatives, along v.
struct FactorBlock {
  alignas(64) double value[4][blockSize];
  alignas(64) double du[4][blockSize];
  alignas(64) double dv[4][blockSize];
};

/// What a row of the grid needs of a factor at one u, from one column on.
struct FactorRow {
  const double* rows;  ///< of poles, summed over v
  const double* n;     ///< basis functions in u
  const double* dn;    ///< and their derivatives
  std::size_t stride;
  int degree;
};

inline FactorRow factorRow(const FactorGrid& grid, std::size_t k, std::size_t column) {
  return {grid.rows(k) + column, grid.basisU(k), grid.basisDerivativesU(k), grid.stride(), grid.degreeU()};
}

/// Sums over the Degree + 1 rows of poles, in registers.
template <int Degree>
BLOSSOM_INLINE void sumRows(const FactorRow& row, std::size_t component, std::size_t count, double* __restrict f,
                            double* __restrict fu, double* __restrict fv) {
  const double* value = row.rows + component * row.stride;
  const double* slope = value + 4 * row.stride;
  const std::size_t next = 8 * row.stride;
  double n[Degree + 1], dn[Degree + 1];
  for (int k = 0; k <= Degree; ++k) n[k] = row.n[k], dn[k] = row.dn[k];
  BLOSSOM_INDEPENDENT_STEPS
  for (std::size_t j = 0; j < count; ++j) {
    double a = 0, b = 0, d = 0;
    for (int k = 0; k <= Degree; ++k) {
      const double x = value[static_cast<std::size_t>(k) * next + j];
      a += n[k] * x;
      b += dn[k] * x;
      d += n[k] * slope[static_cast<std::size_t>(k) * next + j];
    }
    f[j] = a, fu[j] = b, fv[j] = d;
  }
}

BLOSSOM_INLINE void sumRowsOfAnyDegree(const FactorRow& row, std::size_t component, std::size_t count, double* __restrict f,
                                       double* __restrict fu, double* __restrict fv) {
  for (std::size_t j = 0; j < count; ++j) f[j] = fu[j] = fv[j] = 0;
  for (int k = 0; k <= row.degree; ++k) {
    const double* value = row.rows + (static_cast<std::size_t>(k) * 8 + component) * row.stride;
    const double* slope = value + 4 * row.stride;
    const double n = row.n[k], dn = row.dn[k];
    BLOSSOM_INDEPENDENT_STEPS
    for (std::size_t j = 0; j < count; ++j) {
      f[j] += n * value[j];
      fu[j] += dn * value[j];
      fv[j] += n * slope[j];
    }
  }
}

/// One component of a factor, put into a slot of the block.
BLOSSOM_INLINE void sumRows(const FactorRow& row, std::size_t component, std::size_t count, FactorBlock& out,
                            std::size_t slot) {
  double *f = out.value[slot], *fu = out.du[slot], *fv = out.dv[slot];
  if (row.degree == 3) {
    sumRows<3>(row, component, count, f, fu, fv);
  } else {
    sumRowsOfAnyDegree(row, component, count, f, fu, fv);
  }
}

}  // namespace blossom::sweep
