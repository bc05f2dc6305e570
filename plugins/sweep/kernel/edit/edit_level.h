#pragma once
#include <utility>
#include <vector>

#include "geometry/bspline/spline_space.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// What the levels of an edit mean for one direction of a factor. `base` is the space over its base knots.

/// The base knots of a motion, or its own where it was not refined for edits.
BaseKnots baseKnots(const Motion&);

/// The whole space of a level: every span of the base halved `level` times, or knots left out -level times. @param parts
/// copies of the edit along this direction: coarser knots repeat as often
SplineSpace levelSpace(const SplineSpace& base, int level, int parts);

/// Where the functions that are not 0 at t reach; on a knot, up to rounding, those that begin or end there are left out. In
/// a closed space it may pass beyond the domain.
using Reach = std::pair<double, double>;
Reach reachAt(const SplineSpace&, double t);

/// The base with those knots of a finer level that lie in one of the reaches: there, its functions are those of the level.
SplineSpace refinedInside(const SplineSpace& base, const SplineSpace& level, const std::vector<Reach>&);

/// The range lies inside the reach; in a closed space, up to whole periods.
bool liesWithin(const SplineSpace&, const Reach& range, const Reach&);

}  // namespace blossom::sweep
