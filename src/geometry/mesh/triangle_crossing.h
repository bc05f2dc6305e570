#pragma once
#include <optional>

#include "geometry/mesh/triangle_distance.h"

namespace blossom {

/// No area, decided exactly.
bool isCollapsed(const Triangle3&);

/// Where two triangles meet elsewhere than in the corner or the side they share by place, if they do: decided exactly, the
/// place rounded. Triangles in one place meet everywhere. @pre neither is collapsed, all coordinates are numbers
std::optional<Vec3> crossingElsewhere(const Triangle3&, const Triangle3&);

}  // namespace blossom
