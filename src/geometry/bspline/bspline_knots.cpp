#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/bspline/bspline_rows.h"
#include "geometry/bspline/product.h"

namespace blossom {

namespace {

using detail::PoleRows;

void requireInsertable(int degree, const std::vector<double>& knots, std::span<const double> inserted) {
  if (!std::is_sorted(inserted.begin(), inserted.end()))
    throw Error(ErrorCode::InvalidInput, "The knots to insert are not sorted.");
  const double from = knots[static_cast<std::size_t>(degree)],
               to = knots[knots.size() - static_cast<std::size_t>(degree) - 1];
  for (const double knot : inserted)
    if (!(knot >= from && knot <= to))
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("The knot {} to insert lies outside the domain {} to {}.", knot, from, to));
}

std::vector<double> merged(int degree, const std::vector<double>& knots, std::span<const double> inserted) {
  requireInsertable(degree, knots, inserted);
  std::vector<double> result(knots.size() + inserted.size());
  std::merge(knots.begin(), knots.end(), inserted.begin(), inserted.end(), result.begin());
  const auto order = static_cast<std::size_t>(degree) + 1;
  for (std::size_t i = 0; i + order < result.size(); ++i)
    if (result[i] == result[i + order])
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("The knot {} would appear more than {} times, which degree {} does not allow.", result[i],
                              order, degree));
  return result;
}

/// The knots inside the domain, and its ends degree + 1 times.
std::vector<double> clampedKnots(int degree, const std::vector<double>& knots) {
  const auto order = static_cast<std::size_t>(degree) + 1;
  const double from = knots[order - 1], to = knots[knots.size() - order];
  std::vector<double> result(order, from);
  std::copy_if(knots.begin(), knots.end(), std::back_inserter(result),
               [&](double knot) { return knot > from && knot < to; });
  result.insert(result.end(), order, to);
  return result;
}

std::vector<Vec4> applied(const PoleRows& rows, const std::vector<Vec4>& poles, std::size_t itemLength = 1) {
  std::vector<Vec4> result(rows.size() * itemLength);
  detail::applyRows(rows, poles.front().data(), 4 * itemLength, result.front().data());
  return result;
}

Surface changedU(const Surface& surface, int degree, std::vector<double> knots, const PoleRows& rows) {
  return {degree, surface.degreeV, std::move(knots), surface.knotsV, applied(rows, surface.poles, surface.countV())};
}

Surface changedV(const Surface& surface, int degree, std::vector<double> knots, const PoleRows& rows) {
  Surface result{surface.degreeU, degree, surface.knotsU, std::move(knots),
                 std::vector<Vec4>(surface.countU() * rows.size())};
  for (std::size_t i = 0; i < surface.countU(); ++i)
    detail::applyRows(rows, surface.pole(i, 0).data(), 4, result.pole(i, 0).data());
  return result;
}

void requireTimes(int degree, int times) {
  if (times < 0) throw Error(ErrorCode::InvalidInput, fmt::format("A degree cannot be elevated {} times.", times));
  if (degree + times > kMaximumDegree)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("Degree {} is too high; the highest possible is {}.", degree + times, kMaximumDegree));
}

std::vector<double> elevatedKnots(int degree, int times, const std::vector<double>& knots) {
  requireTimes(degree, times);
  const std::vector<double> old = clampedKnots(degree, knots);
  std::vector<double> result;
  for (std::size_t i = 0; i < old.size(); ++i) {
    result.push_back(old[i]);
    if (i + 1 == old.size() || old[i + 1] != old[i]) result.insert(result.end(), static_cast<std::size_t>(times), old[i]);
  }
  return result;
}

}  // namespace

Curve insertKnots(const Curve& curve, std::span<const double> knots) {
  std::vector<double> refined = merged(curve.degree, curve.knots, knots);
  const PoleRows rows = detail::refinementRows(curve.degree, curve.knots, refined);
  return {curve.degree, std::move(refined), applied(rows, curve.poles)};
}

Surface insertKnotsU(const Surface& surface, std::span<const double> knots) {
  std::vector<double> refined = merged(surface.degreeU, surface.knotsU, knots);
  const PoleRows rows = detail::refinementRows(surface.degreeU, surface.knotsU, refined);
  return changedU(surface, surface.degreeU, std::move(refined), rows);
}

Surface insertKnotsV(const Surface& surface, std::span<const double> knots) {
  std::vector<double> refined = merged(surface.degreeV, surface.knotsV, knots);
  const PoleRows rows = detail::refinementRows(surface.degreeV, surface.knotsV, refined);
  return changedV(surface, surface.degreeV, std::move(refined), rows);
}

Curve clamped(const Curve& curve) {
  std::vector<double> knots = clampedKnots(curve.degree, curve.knots);
  const PoleRows rows = detail::refinementRows(curve.degree, curve.knots, knots);
  return {curve.degree, std::move(knots), applied(rows, curve.poles)};
}

Surface clamped(const Surface& surface) {
  std::vector<double> knotsU = clampedKnots(surface.degreeU, surface.knotsU),
                      knotsV = clampedKnots(surface.degreeV, surface.knotsV);
  const PoleRows rowsU = detail::refinementRows(surface.degreeU, surface.knotsU, knotsU);
  const PoleRows rowsV = detail::refinementRows(surface.degreeV, surface.knotsV, knotsV);
  return changedV(changedU(surface, surface.degreeU, std::move(knotsU), rowsU), surface.degreeV, std::move(knotsV), rowsV);
}

Curve elevateDegree(const Curve& curve, int times) {
  std::vector<double> knots = elevatedKnots(curve.degree, times, curve.knots);
  const PoleRows rows = detail::elevationRows(curve.degree, curve.knots, times, knots);
  return {curve.degree + times, std::move(knots), applied(rows, curve.poles)};
}

Surface elevateDegree(const Surface& surface, int timesU, int timesV) {
  std::vector<double> knotsU = elevatedKnots(surface.degreeU, timesU, surface.knotsU);
  std::vector<double> knotsV = elevatedKnots(surface.degreeV, timesV, surface.knotsV);
  const PoleRows rowsU = detail::elevationRows(surface.degreeU, surface.knotsU, timesU, knotsU);
  const PoleRows rowsV = detail::elevationRows(surface.degreeV, surface.knotsV, timesV, knotsV);
  return changedV(changedU(surface, surface.degreeU + timesU, std::move(knotsU), rowsU), surface.degreeV + timesV,
                  std::move(knotsV), rowsV);
}

}  // namespace blossom
