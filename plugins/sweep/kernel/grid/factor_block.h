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
  const CubicSpan* span;  ///< nullptr: by the basis functions
  double fromMiddle;
};

BLOSSOM_INLINE FactorRow factorRow(const FactorGrid& grid, std::size_t k, std::size_t column) {
  return {grid.rows(k) + column, grid.basisU(k), grid.basisDerivativesU(k), grid.stride(),
          grid.degreeU(),        grid.span(k),   grid.fromMiddle(k)};
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

/// The coefficients of a block over one span: for each slot and power an array along v.
struct PowerBlock {
  alignas(64) double value[4][4][blockSize];
  alignas(64) double slope[4][4][blockSize];
  const CubicSpan* of = nullptr;
};

/// @param rows the array of the first of four rows of poles, `next` from one to the following
BLOSSOM_INLINE void toPowers(const CubicSpan& span, const double* rows, std::size_t next, std::size_t count,
                             double (&out)[4][blockSize]) {
  for (std::size_t power = 0; power < 4; ++power) {
    const double n0 = span.weights[power][0], n1 = span.weights[power][1], n2 = span.weights[power][2],
                 n3 = span.weights[power][3];
    BLOSSOM_INDEPENDENT_STEPS
    for (std::size_t j = 0; j < count; ++j)
      out[power][j] = n0 * rows[j] + n1 * rows[next + j] + n2 * rows[2 * next + j] + n3 * rows[3 * next + j];
  }
}

/// Horner's scheme for the value, its derivative and the v derivative.
BLOSSOM_INLINE void sumPowers(const PowerBlock& powers, std::size_t slot, double t, std::size_t count, FactorBlock& out) {
  const auto &c = powers.value[slot], &s = powers.slope[slot];
  double *f = out.value[slot], *fu = out.du[slot], *fv = out.dv[slot];
  BLOSSOM_INDEPENDENT_STEPS
  for (std::size_t j = 0; j < count; ++j) {
    double value = c[3][j], slope = value;
    value = value * t + c[2][j];
    slope = slope * t + value;
    value = value * t + c[1][j];
    slope = slope * t + value;
    f[j] = value * t + c[0][j];
    fu[j] = slope;
    fv[j] = ((s[3][j] * t + s[2][j]) * t + s[1][j]) * t + s[0][j];
  }
}

/// The slots from the first one on, each of the component that is named for it. `powers` keeps what rows of one span share.
template <std::size_t First>
BLOSSOM_INLINE void sumFactor(const FactorRow& row, const std::size_t (&components)[4], std::size_t count,
                              PowerBlock& powers, FactorBlock& out) {
  if (!row.span) {
    for (std::size_t slot = First; slot < 4; ++slot) sumRows(row, components[slot], count, out, slot);
    return;
  }
  if (powers.of != row.span) {
    powers.of = row.span;
    for (std::size_t slot = First; slot < 4; ++slot) {
      const double* rows = row.rows + components[slot] * row.stride;
      toPowers(*row.span, rows, 8 * row.stride, count, powers.value[slot]);
      toPowers(*row.span, rows + 4 * row.stride, 8 * row.stride, count, powers.slope[slot]);
    }
  }
  for (std::size_t slot = First; slot < 4; ++slot) sumPowers(powers, slot, row.fromMiddle, count, out);
}

}  // namespace blossom::sweep
