#include "kernel/edit/section_rows.h"

#include <cmath>

#include "kernel/grid/basis_table.h"

namespace blossom::sweep {

namespace {
constexpr double sameKnot = 1e-12;
}

std::vector<Vec4> sectionRows(const Surface& surface, double v) {
  const BasisTable basis = tabulateBasis(surface.degreeV, surface.knotsV, {&v, 1});
  std::vector<Vec4> rows(surface.countU(), Vec4::Zero());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < basis.value.size(); ++j) rows[i] += basis.value[j] * surface.pole(i, basis.first[0] + j);
  return rows;
}

std::size_t rowsPerPart(const Surface& closed, int n) {
  const std::size_t free = closed.countU() - static_cast<std::size_t>(closed.degreeU), parts = static_cast<std::size_t>(n);
  if (free % parts != 0) return 0;
  const auto [first, last] = closed.domainU();
  for (std::size_t i = 0; i + free / parts < closed.knotsU.size(); ++i)
    if (std::abs(closed.knotsU[i + free / parts] - closed.knotsU[i] - (last - first) / n) > sameKnot * (last - first))
      return 0;
  return free / parts;
}

bool knotsAreMirrored(const Surface& surface) {
  const auto [first, last] = surface.domainU();
  const std::vector<double>& knots = surface.knotsU;
  for (std::size_t i = 0; i < knots.size(); ++i)
    if (std::abs(knots[i] + knots[knots.size() - 1 - i] - (first + last)) > sameKnot * (last - first)) return false;
  return true;
}

}  // namespace blossom::sweep
