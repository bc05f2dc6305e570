#pragma once
#include <vector>

#include "geometry/mesh/triangle_distance.h"

namespace blossom {

/// What two triangles of one plane have in common: a convex polygon, in doubles; empty when it is nothing. The second
/// triangle's plane counts.
std::vector<Vec3> commonPolygon(const Triangle3&, const Triangle3&);

/// The area of a planar convex polygon.
double areaOf(const std::vector<Vec3>& polygon);

}  // namespace blossom
