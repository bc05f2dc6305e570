#pragma once
#include "geometry/planar/region.h"

namespace blossom::minkowski {

/// Centroid of the area, of curves within a chord of them in mm. @pre the area is not 0
Vec2 centroid(const Region&, double chord);

/// Handle position of a control shape: the centroid of its area, within a thousandth of its size; the middle of its box when
/// the area is 0.
Vec2 centreOf(const Region&);

}  // namespace blossom::minkowski
