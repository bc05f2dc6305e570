#pragma once
#include "core/progress.h"
#include "core/vector.h"
#include "geometry/planar/region.h"

namespace blossom::minkowski {

/// How far a shape is from being convex: the largest distance of a point of its hull from the shape (the Hausdorff distance
/// of both, because the hull contains the shape).
struct HullDistance {
  double distance = 0;     ///< mm, of a point that was found; in practice to all digits
  double atMost = 0;       ///< mm, no point is farther
  Vec2 at = Vec2::Zero();  ///< a point of the hull at that distance
};

/// By squares that become smaller where the distance may be larger than the largest one found: it changes by no more than
/// the way one goes. Lines and arcs are exact, free-form curves within the precision; the last digits are those of a
/// search uphill from the place found. @param hull convex, around the shape
/// @param precision mm, or a thousandth of the distance if that is more. O(n log(size / precision)) for shapes whose
/// farthest points are few. @throws Error Cancelled.
HullDistance distanceToHull(const Region& shape, const Region& hull, double precision, const Progress& = Progress::none());

/// A radius within which all of a region lies around some point: that of the smallest circle around it (Welzl 1991), too
/// large by at most `chord` mm. Expected O(n). @throws Error Cancelled.
double circumradius(const Region&, double chord, const Progress& = Progress::none());

}  // namespace blossom::minkowski
