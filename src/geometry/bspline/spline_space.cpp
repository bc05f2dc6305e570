#include "geometry/bspline/spline_space.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/bspline/bspline.h"

namespace blossom {

namespace {

/// Index in 0..n-1 and the number of periods passed.
std::pair<std::size_t, long> indexInPeriod(long index, std::size_t n) {
  const long count = static_cast<long>(n);
  const long turns = index >= 0 ? index / count : -((-index + count - 1) / count);
  return {static_cast<std::size_t>(index - turns * count), turns};
}

std::vector<double> distinctInDomain(const SplineSpace& space) {
  const auto [first, last] = space.domain();
  std::vector<double> breaks{first};
  for (const double knot : space.knots)
    if (knot > breaks.back() && knot <= last) breaks.push_back(knot);
  return breaks;
}

/// Once more coarse. @returns the same knots when nothing can be left out
std::vector<double> everySecond(const SplineSpace& space, std::size_t parts) {
  const std::vector<double> breaks = distinctInDomain(space);
  const std::size_t spans = breaks.size() - 1, part = spans % parts == 0 ? spans / parts : spans;
  std::vector<double> kept;
  for (const double knot : innerKnots(space)) {
    const auto found = std::lower_bound(breaks.begin(), breaks.end(), knot);
    const std::size_t index = static_cast<std::size_t>(found - breaks.begin()) % part;
    if (std::min(index, part - index) % 2 == 0) kept.push_back(knot);
  }
  return kept;
}

}  // namespace

SplineSpace spaceOf(const Curve& curve) { return {curve.degree, curve.knots, 0}; }
SplineSpace spaceInU(const Surface& surface, double closure) { return {surface.degreeU, surface.knotsU, closure}; }
SplineSpace spaceInV(const Surface& surface) { return {surface.degreeV, surface.knotsV, 0}; }

std::vector<double> unwrappedKnots(int degree, const std::vector<double>& period) {
  const std::size_t n = period.size() - 1;
  const double length = period[n] - period[0];
  std::vector<double> knots;
  knots.reserve(period.size() + 2 * static_cast<std::size_t>(degree));
  for (long i = -degree; i <= static_cast<long>(n) + degree; ++i) {
    // The given values stay untouched inside the period; only the repetitions are shifted.
    if (i >= 0 && i <= static_cast<long>(n)) {
      knots.push_back(period[static_cast<std::size_t>(i)]);
    } else {
      const auto [index, turns] = indexInPeriod(i, n);
      // From the nearer end, so that knots repeated at the seam stay exactly equal to it.
      knots.push_back(turns < 0 ? period[0] - (period[n] - period[index]) + static_cast<double>(turns + 1) * length
                                : period[n] + (period[index] - period[0]) + static_cast<double>(turns - 1) * length);
    }
  }
  return knots;
}

std::vector<double> innerKnots(const SplineSpace& space) {
  const auto [first, last] = space.domain();
  std::vector<double> inner;
  std::copy_if(space.knots.begin(), space.knots.end(), std::back_inserter(inner),
               [first = first, last = last](double knot) { return knot > first && knot < last; });
  return inner;
}

SplineSpace withInnerKnots(const SplineSpace& space, std::span<const double> inner) {
  const auto [first, last] = space.domain();
  // Of a closed space one period, which the unwrapped vector continues.
  const std::ptrdiff_t outside = space.closure == 0 ? 0 : space.degree;
  const auto begin = space.knots.begin() + outside, end = space.knots.end() - outside;
  SplineSpace result{space.degree, {begin, std::upper_bound(begin, end, first)}, space.closure};
  result.knots.insert(result.knots.end(), inner.begin(), inner.end());
  result.knots.insert(result.knots.end(), std::lower_bound(begin, end, last), end);
  if (space.closure != 0) result.knots = unwrappedKnots(space.degree, result.knots);
  return result;
}

std::vector<double> unitedKnots(std::span<const double> a, std::span<const double> b) {
  std::vector<double> all;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

SplineSpace halved(const SplineSpace& space, int times) {
  const std::vector<double> breaks = distinctInDomain(space);
  const double pieces = std::ldexp(1.0, times);
  std::vector<double> between;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    for (double k = 1; k < pieces; ++k) {
      const double knot = breaks[i] + (breaks[i + 1] - breaks[i]) * (k / pieces);
      if (knot > (between.empty() ? breaks[i] : std::max(breaks[i], between.back())) && knot < breaks[i + 1])
        between.push_back(knot);
    }
  return withInnerKnots(space, unitedKnots(innerKnots(space), between));
}

SplineSpace coarsened(const SplineSpace& space, int times, std::size_t parts) {
  SplineSpace result = space;
  for (int k = 0; k < times; ++k) {
    SplineSpace next = withInnerKnots(result, everySecond(result, parts));
    const bool tooFew = next.closure != 0 && next.size() <= static_cast<std::size_t>(next.degree);
    if (tooFew || next.knots == result.knots) break;
    result = std::move(next);
  }
  return result;
}

double afterPeriods(double closure, long turns) {
  double factor = 1;
  for (; turns > 0; --turns) factor *= closure;
  for (; turns < 0; ++turns) factor /= closure;
  return factor;
}

std::vector<FunctionValue> functionsAt(const SplineSpace& space, double t) {
  const auto width = static_cast<std::size_t>(space.degree) + 1;
  const std::size_t span = findSpan(space.degree, space.knots, t), count = space.size();
  std::vector<double> values(width);
  basisDerivatives(space.degree, space.knots, span, t, 0, values);
  std::vector<FunctionValue> result;
  for (std::size_t k = 0; k < width; ++k) {
    const auto [function, turns] = indexInPeriod(static_cast<long>(span + 1 - width + k), count);
    const double value = turns == 0 ? values[k] : afterPeriods(space.closure, turns) * values[k];
    const auto at = std::lower_bound(result.begin(), result.end(), function,
                                     [](const FunctionValue& each, std::size_t wanted) { return each.function < wanted; });
    if (at != result.end() && at->function == function)
      at->value += value;
    else
      result.insert(at, {function, value});
  }
  std::erase_if(result, [](const FunctionValue& each) { return each.value == 0; });
  return result;
}

}  // namespace blossom
