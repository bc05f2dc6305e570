#pragma once
#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// A + B of two convex regions of lines and arcs: for every direction of the normal, the sum of the two boundary points. No
/// polygons, hence exact to rounding for any radii. O(n + m) log (n + m).
/// @pre both are convex (see sound_region.h)
/// @throws Cancelled
Region convexSum(const Region& a, const Region& b, const Progress& = Progress::none());

}  // namespace blossom::planar
