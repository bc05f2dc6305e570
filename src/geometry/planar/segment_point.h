#pragma once
#include "geometry/planar/region.h"

/// Points of a segment and beside it; for many points see boundary_tree.h.
namespace blossom {

/// Halfway along a line or an arc; of a spline, halfway between its knots.
Vec2 middleOf(const Segment&);
/// Of a point from a line or an arc. @pre not a spline
double distanceTo(const Segment&, const Vec2&);
/// How often a segment crosses the ray from a point in the direction +x: upwards less downwards. Of levels on which segments
/// end it counts the part above, so that a closed path has its winding number as sum.
int crossingsToTheRight(const Segment&, const Vec2&);

}  // namespace blossom
