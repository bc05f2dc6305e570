#pragma once
#include "geometry/planar/region.h"
#include "geometry/shape/toolpath.h"

namespace blossom::pocket {

/// The toolpath moved: moves, stock and marks.
Toolpath translated(Toolpath, const Vec3& by);

/// Corners of the bounding box of a region.
std::pair<Vec2, Vec2> boxOf(const Region&);

}  // namespace blossom::pocket
