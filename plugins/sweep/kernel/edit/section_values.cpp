#include "kernel/edit/section_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/grid/basis_table.h"

namespace blossom::sweep {

namespace {

/// Poles of the curve in u that a factor is at one v.
std::vector<Vec4> rowsAt(const Surface& surface, double v) {
  const BasisTable basis = tabulateBasis(surface.degreeV, surface.knotsV, {&v, 1});
  std::vector<Vec4> rows(surface.countU(), Vec4::Zero());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < basis.value.size(); ++j) rows[i] += basis.value[j] * surface.pole(i, basis.first[0] + j);
  return rows;
}

std::vector<double> breaksOf(const Surface& surface) {
  const auto [first, last] = surface.domainU();
  std::vector<double> breaks;
  for (const double knot : surface.knotsU)
    if (knot >= first && knot <= last && (breaks.empty() || knot > breaks.back())) breaks.push_back(knot);
  return breaks;
}

/// Degree + 1 parameters in each piece that is more than rounding.
std::vector<double> insidePieces(std::vector<double> breaks, int degree, double rounding) {
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> places;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double length = breaks[i + 1] - breaks[i];
    for (int k = 0; k <= degree && length > rounding; ++k) places.push_back(breaks[i] + length * (k + 0.5) / (degree + 1));
  }
  return places;
}

}  // namespace

double sameKnot(std::pair<double, double> domain) {
  const double coordinate = std::max(std::abs(domain.first), std::abs(domain.second));
  return std::max(1e-12 * (domain.second - domain.first), 8 * std::numeric_limits<double>::epsilon() * coordinate);
}

bool knotsRepeat(const SplineSpace& closed, int n) {
  const std::size_t free = closed.size(), parts = static_cast<std::size_t>(n);
  if (free % parts != 0) return false;
  const auto [first, last] = closed.domain();
  for (std::size_t i = 0; i + free / parts < closed.knots.size(); ++i)
    if (std::abs(closed.knots[i + free / parts] - closed.knots[i] - (last - first) / n) > sameKnot(closed.domain()))
      return false;
  return true;
}

bool knotsAreMirrored(const SplineSpace& space) {
  const auto [first, last] = space.domain();
  const std::vector<double>& knots = space.knots;
  for (std::size_t i = 0; i < knots.size(); ++i)
    if (std::abs(knots[i] + knots[knots.size() - 1 - i] - (first + last)) > sameKnot(space.domain())) return false;
  return true;
}

std::vector<double> placesToCompare(const Surface& surface, int fold) {
  const auto [first, last] = surface.domainU();
  const std::vector<double> own = breaksOf(surface);
  std::vector<double> all;
  for (int k = 0; k < fold; ++k)
    for (const double knot : own) {
      const double copy = knot + (last - first) * k / fold;
      all.push_back(std::clamp(copy > last ? copy - (last - first) : copy, first, last));
    }
  return insidePieces(std::move(all), surface.degreeU, sameKnot(surface.domainU()));
}

std::vector<double> placesToCompareMirrored(const Surface& surface) {
  const auto [first, last] = surface.domainU();
  std::vector<double> all = breaksOf(surface);
  for (const double knot : breaksOf(surface)) all.push_back(std::clamp(first + last - knot, first, last));
  return insidePieces(std::move(all), surface.degreeU, sameKnot(surface.domainU()));
}

std::vector<Vec4> sectionValues(const Surface& surface, double v, std::span<const double> u, double closure) {
  const auto [first, last] = surface.domainU();
  const std::vector<Vec4> rows = rowsAt(surface, v);
  std::vector<double> inside(u.begin(), u.end());
  for (double& each : inside) each = std::clamp(each > last ? each - (last - first) : each, first, last);
  const BasisTable basis = tabulateBasis(surface.degreeU, surface.knotsU, inside);
  std::vector<Vec4> values(u.size(), Vec4::Zero());
  for (std::size_t k = 0; k < u.size(); ++k) {
    for (std::size_t i = 0; i < basis.values(k).size(); ++i) values[k] += basis.values(k)[i] * rows[basis.first[k] + i];
    if (u[k] > last && closure != 0) values[k] *= closure;
  }
  return values;
}

}  // namespace blossom::sweep
