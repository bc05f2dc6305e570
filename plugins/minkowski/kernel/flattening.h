#pragma once
#include <string>

#include "core/progress.h"
#include "geometry/region.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// Polygons within `tolerance` mm of a region.
/// @param name what the region is called in messages, "control shape 2"
/// @throws Error InvalidInput when it is empty, open, not finite, crosses itself or has a hole outside; LimitExceeded when
/// it reaches farther than 1e9 mm or needs more than 200,000 corners: each names the place. Cancelled. O(n log n) for
/// well-spread edges.
Polygons flattened(const Region&, double tolerance, const std::string& name, const Progress& = Progress::none());

/// Straight lines along the loops, outer loops first and then their holes. An empty set gives a region without loops.
Region toRegion(const Polygons&);

}  // namespace blossom::minkowski
