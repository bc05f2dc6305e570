#pragma once
#include "geometry/planar/region.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// Centroid of the area. @pre the area is not 0
Vec2 centroid(const Polygons&);

/// Handle position of a control shape: the centroid of its area, within a thousandth of its size; the middle of its box when
/// the area is 0.
Vec2 centreOf(const Region&);

}  // namespace blossom::minkowski
