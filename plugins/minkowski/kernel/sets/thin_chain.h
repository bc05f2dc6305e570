#pragma once
#include <vector>

#include "core/vector.h"
#include "geometry/planar/region.h"

namespace blossom::minkowski {

/// Few lines and arcs within a distance of points that follow one another, from the first to the last of them. O(n^2).
/// @param isRing whether the last point is the first one
Path fittedChain(const std::vector<Vec2>& points, bool isRing, double within);

}  // namespace blossom::minkowski
