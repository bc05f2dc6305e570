#include "kernel/edit/edit_level.h"

#include <algorithm>
#include <cmath>

#include "geometry/bspline/bspline.h"

namespace blossom::sweep {

namespace {

/// A place this near to a knot, as a share of its span, is on it, as are its copies around a motion up to rounding;
/// functions that begin or end there have no larger share of the largest one than the other number.
constexpr double onKnot = 1e-10, hardlyThere = 1e-9;

}  // namespace

BaseKnots baseKnots(const Motion& motion) {
  if (motion.base) return *motion.base;
  const auto both = [](const Surface& factor) {
    return std::array{innerKnots(spaceInU(factor, 0)), innerKnots(spaceInV(factor))};
  };
  return {innerKnots(spaceOf(motion.trajectory)), both(motion.orientation), both(motion.scaling)};
}

SplineSpace levelSpace(const SplineSpace& base, int level, int parts) {
  if (level == 0) return base;
  return level > 0 ? halved(base, level) : coarsened(base, -level, static_cast<std::size_t>(std::max(parts, 1)));
}

Reach reachAt(const SplineSpace& space, double t) {
  const auto width = static_cast<std::size_t>(space.degree) + 1;
  const std::size_t span = findSpan(space.degree, space.knots, t), first = span + 1 - width;
  std::vector<double> values(width);
  basisDerivatives(space.degree, space.knots, span, t, 0, values);
  const double length = space.knots[span + 1] - space.knots[span],
               off = std::min(t - space.knots[span], space.knots[span + 1] - t);
  const double least = off < onKnot * length ? hardlyThere * *std::max_element(values.begin(), values.end()) : 0;
  Reach reach{t, t};
  for (std::size_t k = 0; k < width; ++k)
    if (values[k] > least) {
      reach.first = std::min(reach.first, space.knots[first + k]);
      reach.second = std::max(reach.second, space.knots[first + k + width]);
    }
  return reach;
}

bool liesWithin(const SplineSpace& space, const Reach& range, const Reach& reach) {
  const auto [first, last] = space.domain();
  const double period = last - first, rounding = 1e-12 * period;
  const auto inside = [&](double turns) {
    return range.first + turns * period >= reach.first - rounding &&
           range.second + turns * period <= reach.second + rounding;
  };
  if (space.closure == 0) return inside(0);
  return reach.second - reach.first >= period - rounding ||
         inside(std::ceil((reach.first - rounding - range.first) / period));
}

SplineSpace refinedInside(const SplineSpace& base, const SplineSpace& level, const std::vector<Reach>& reaches) {
  std::vector<double> knots;
  for (const double knot : innerKnots(level))
    if (std::any_of(reaches.begin(), reaches.end(), [&](const Reach& reach) {
          return liesWithin(level, {knot, knot}, reach);
        }))
      knots.push_back(knot);
  return withInnerKnots(base, unitedKnots(innerKnots(base), knots));
}

}  // namespace blossom::sweep
