#pragma once
#include <optional>

#include "geometry/mesh/triangle_distance.h"

namespace blossom {

/// Whether the area is zero, decided exactly.
bool isCollapsed(const Triangle3&);

/// A point where two triangles intersect outside the corner or side they share by position; empty when there is none.
/// Decided exactly, the point rounded. Triangles with the same three corners intersect. @pre neither is collapsed, all
/// coordinates are finite
std::optional<Vec3> crossingElsewhere(const Triangle3&, const Triangle3&);

}  // namespace blossom
