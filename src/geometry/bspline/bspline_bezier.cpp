#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/bspline/bspline_rows.h"
#include "geometry/bspline/product.h"

namespace blossom {

namespace detail {

std::vector<double> distinctKnots(int degree, std::span<const double> knots) {
  std::vector<double> result;
  std::unique_copy(knots.begin() + degree, knots.end() - degree, std::back_inserter(result));
  return result;
}

std::vector<double> bezierKnots(int degree, std::span<const double> breaks) {
  std::vector<double> knots;
  knots.reserve(breaks.size() * (static_cast<std::size_t>(degree) + 1));
  for (const double at : breaks) knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, at);
  return knots;
}

std::vector<double> binomials(int n) {
  std::vector<double> row(static_cast<std::size_t>(n) + 1, 1.0);
  for (std::size_t k = 1; k < row.size(); ++k)
    row[k] = std::round(row[k - 1] * (static_cast<double>(n + 1) - static_cast<double>(k)) / static_cast<double>(k));
  return row;
}

namespace {

/// How much errors in the Bezier poles over [from, to] grow in the blossom at the arguments: the logarithm of the product of
/// |1 - s| + |s|.
double errorGrowth(double from, double to, std::span<const double> arguments) {
  double growth = 0;
  for (const double x : arguments) {
    const double s = (x - from) / (to - from);
    if (s < 0 || s > 1) growth += std::log(std::abs(1 - s) + std::abs(s));
  }
  return growth;
}

/// The best piece for the pole with these knots (all that its support touches, ends included).
std::size_t bestPiece(std::span<const double> breaks, std::span<const double> support) {
  const auto arguments = support.subspan(1, support.size() - 2);
  const std::size_t pieces = breaks.size() - 1;
  // outside the domain there is nothing but the first and the last piece
  std::size_t begin = std::min(lastKnotNotAbove(breaks, std::max(support.front(), breaks.front())), pieces - 1),
              best = begin;
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = begin; i < pieces && (i == begin || breaks[i] < support.back()); ++i) {
    const double growth = errorGrowth(breaks[i], breaks[i + 1], arguments);
    if (growth < minimum) minimum = growth, best = i;
    if (growth == 0) break;
  }
  return best;
}

}  // namespace

PoleRows blossomRows(int degree, std::span<const double> breaks, std::span<const double> knots, bool scaled) {
  const auto order = static_cast<std::size_t>(degree) + 1;
  PoleRows rows;
  rows.width = order;
  rows.first.resize(knots.size() - order);
  rows.weights.assign(rows.size() * order, 0.0);
  const std::vector<double> binomial = binomials(degree);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto support = knots.subspan(i, order + 1);
    const std::size_t piece = bestPiece(breaks, support);
    const double from = breaks[piece], length = breaks[piece + 1] - from;
    rows.first[i] = piece * order;
    double* const weights = &rows.weights[i * order];
    weights[0] = 1;
    for (std::size_t m = 1; m < order; ++m) {
      const double s = (support[m] - from) / length, rest = (breaks[piece + 1] - support[m]) / length;
      for (std::size_t k = m; k > 0; --k) weights[k] = weights[k] * rest + weights[k - 1] * s;
      weights[0] *= rest;
    }
    if (scaled)
      for (std::size_t k = 0; k < order; ++k) weights[k] /= binomial[k];
  }
  return rows;
}

}  // namespace detail

namespace {

using detail::PoleRows;

/// Between patch after patch and rows through all patches. `grid` has spansU * (degreeU + 1) rows of spansV * (degreeV + 1)
/// poles.
template <typename Copy>
void forEachPatchRow(const BezierSurface& shape, const Copy& copy) {
  const auto orderU = static_cast<std::size_t>(shape.degreeU) + 1, orderV = static_cast<std::size_t>(shape.degreeV) + 1;
  const std::size_t spansU = shape.breaksU.size() - 1, spansV = shape.breaksV.size() - 1;
  for (std::size_t a = 0; a < spansU; ++a)
    for (std::size_t b = 0; b < spansV; ++b)
      for (std::size_t i = 0; i < orderU; ++i)
        copy(((a * spansV + b) * orderU + i) * orderV, ((a * orderU + i) * spansV + b) * orderV, orderV);
}

[[noreturn]] void rejectPieces(const std::string& what) { throw Error(ErrorCode::InvalidInput, what); }

void requirePieces(int degree, const std::vector<double>& breaks, std::span<const double> knots) {
  if (degree < 1 || degree > kMaximumDegree)
    rejectPieces(fmt::format("Bezier pieces of degree {} cannot be joined.", degree));
  if (breaks.size() < 2) rejectPieces("There are no Bezier pieces to join.");
  for (std::size_t i = 1; i < breaks.size(); ++i)
    if (!(breaks[i - 1] < breaks[i])) rejectPieces("The breaks between Bezier pieces do not increase.");
  if (knots.size() < 2 * (static_cast<std::size_t>(degree) + 1) || !std::is_sorted(knots.begin(), knots.end()))
    rejectPieces("The knots for the joined Bezier pieces are too few or decrease.");
  for (const double knot : knots)
    if (!std::isfinite(knot) ||
        (knot > breaks.front() && knot < breaks.back() && !std::binary_search(breaks.begin(), breaks.end(), knot)))
      rejectPieces(fmt::format("The knot {} is no break between Bezier pieces.", knot));
}

}  // namespace

BezierCurve toBezier(const Curve& curve) {
  BezierCurve result{curve.degree, detail::distinctKnots(curve.degree, curve.knots), {}};
  const PoleRows rows = detail::refinementRows(curve.degree, curve.knots, detail::bezierKnots(curve.degree, result.breaks));
  result.poles.resize(rows.size());
  detail::applyRows(rows, curve.poles.front().data(), 4, result.poles.front().data());
  return result;
}

BezierSurface toBezier(const Surface& surface) {
  BezierSurface result{surface.degreeU,
                       surface.degreeV,
                       detail::distinctKnots(surface.degreeU, surface.knotsU),
                       detail::distinctKnots(surface.degreeV, surface.knotsV),
                       {}};
  const PoleRows rowsU =
      detail::refinementRows(surface.degreeU, surface.knotsU, detail::bezierKnots(surface.degreeU, result.breaksU));
  const PoleRows rowsV =
      detail::refinementRows(surface.degreeV, surface.knotsV, detail::bezierKnots(surface.degreeV, result.breaksV));
  const std::size_t nv = surface.countV();
  std::vector<Vec4> half(rowsU.size() * nv), grid(rowsU.size() * rowsV.size());
  detail::applyRows(rowsU, surface.poles.front().data(), nv * 4, half.front().data());
  for (std::size_t i = 0; i < rowsU.size(); ++i)
    detail::applyRows(rowsV, half[i * nv].data(), 4, grid[i * rowsV.size()].data());
  result.poles.resize(grid.size());
  forEachPatchRow(
      result, [&](std::size_t patch, std::size_t row, std::size_t n) { std::copy_n(&grid[row], n, &result.poles[patch]); });
  return result;
}

Curve fromBezier(const BezierCurve& pieces, std::span<const double> knots) {
  requirePieces(pieces.degree, pieces.breaks, knots);
  if (pieces.poles.size() != (pieces.breaks.size() - 1) * (static_cast<std::size_t>(pieces.degree) + 1))
    rejectPieces("The number of Bezier poles does not fit the breaks.");
  const PoleRows rows = detail::blossomRows(pieces.degree, pieces.breaks, knots, false);
  Curve result{pieces.degree, {knots.begin(), knots.end()}, std::vector<Vec4>(rows.size())};
  detail::applyRows(rows, pieces.poles.front().data(), 4, result.poles.front().data());
  return result;
}

Surface fromBezier(const BezierSurface& pieces, std::span<const double> knotsU, std::span<const double> knotsV) {
  requirePieces(pieces.degreeU, pieces.breaksU, knotsU);
  requirePieces(pieces.degreeV, pieces.breaksV, knotsV);
  const std::size_t nu = (pieces.breaksU.size() - 1) * (static_cast<std::size_t>(pieces.degreeU) + 1);
  const std::size_t nv = (pieces.breaksV.size() - 1) * (static_cast<std::size_t>(pieces.degreeV) + 1);
  if (pieces.poles.size() != nu * nv) rejectPieces("The number of Bezier poles does not fit the breaks.");
  const PoleRows rowsU = detail::blossomRows(pieces.degreeU, pieces.breaksU, knotsU, false);
  const PoleRows rowsV = detail::blossomRows(pieces.degreeV, pieces.breaksV, knotsV, false);
  std::vector<Vec4> grid(nu * nv), half(rowsU.size() * nv);
  forEachPatchRow(
      pieces, [&](std::size_t patch, std::size_t row, std::size_t n) { std::copy_n(&pieces.poles[patch], n, &grid[row]); });
  detail::applyRows(rowsU, grid.front().data(), nv * 4, half.front().data());
  Surface result{pieces.degreeU,
                 pieces.degreeV,
                 {knotsU.begin(), knotsU.end()},
                 {knotsV.begin(), knotsV.end()},
                 std::vector<Vec4>(rowsU.size() * rowsV.size())};
  for (std::size_t i = 0; i < rowsU.size(); ++i)
    detail::applyRows(rowsV, half[i * nv].data(), 4, result.poles[i * rowsV.size()].data());
  return result;
}

}  // namespace blossom
