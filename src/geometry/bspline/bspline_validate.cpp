#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline.h"

namespace blossom {

namespace {

[[noreturn]] void reject(const std::string& what) {
  throw Error(ErrorCode::InvalidInput, what, "Give degree + 1 more knots than poles, in non-decreasing order.");
}

void validateDegree(int degree, const char* name) {
  if (degree < 1)
    throw Error(ErrorCode::InvalidInput, fmt::format("The degree{} is {}; it must be at least 1.", name, degree));
  if (degree > kMaximumDegree)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("The degree{} is {}; the highest possible is {}.", name, degree, kMaximumDegree));
}

void validateMultiplicity(int degree, const std::vector<double>& knots, const char* name) {
  for (std::size_t i = 0, end = 0; i < knots.size(); i = end) {
    while (end < knots.size() && knots[end] == knots[i]) ++end;
    if (end - i > static_cast<std::size_t>(degree) + 1)
      reject(
          fmt::format("The knot {}{} appears {} times; degree {} allows {}.", knots[i], name, end - i, degree, degree + 1));
  }
}

/// @param name " in u", " in v" or nothing
void validateKnots(int degree, const std::vector<double>& knots, const char* name) {
  validateDegree(degree, name);
  const auto order = static_cast<std::size_t>(degree) + 1;
  if (knots.size() < 2 * order)
    reject(fmt::format("There are {} knots{}; degree {} needs at least {}.", knots.size(), name, degree, 2 * order));
  for (const double knot : knots)
    if (!std::isfinite(knot)) reject(fmt::format("A knot{} is not a finite number.", name));
  const auto drop = std::is_sorted_until(knots.begin(), knots.end());
  if (drop != knots.end()) reject(fmt::format("The knots{} decrease: {} stands after {}.", name, *drop, *(drop - 1)));
  if (!(knots[order - 1] < knots[knots.size() - order])) reject(fmt::format("The parameter domain{} is empty.", name));
  validateMultiplicity(degree, knots, name);
}

void validatePoles(const std::vector<Vec4>& poles) {
  for (std::size_t i = 0; i < poles.size(); ++i)
    if (!poles[i].allFinite()) reject(fmt::format("Pole {} holds a value that is not finite.", i));
}

}  // namespace

void validate(const Curve& curve) {
  validateKnots(curve.degree, curve.knots, "");
  const std::size_t expected = curve.knots.size() - static_cast<std::size_t>(curve.degree) - 1;
  if (curve.poles.size() != expected)
    reject(fmt::format("The curve has {} poles; {} knots and degree {} go with {}.", curve.poles.size(), curve.knots.size(),
                       curve.degree, expected));
  validatePoles(curve.poles);
}

void validate(const Surface& surface) {
  validateKnots(surface.degreeU, surface.knotsU, " in u");
  validateKnots(surface.degreeV, surface.knotsV, " in v");
  const std::size_t nu = surface.countU(), nv = surface.countV();
  if (surface.poles.size() != nu * nv)
    reject(fmt::format("The surface has {} poles; its knots and degrees go with {} x {}.", surface.poles.size(), nu, nv));
  validatePoles(surface.poles);
}

}  // namespace blossom
