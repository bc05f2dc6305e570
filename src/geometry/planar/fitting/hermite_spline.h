#pragma once
#include <span>
#include <vector>

#include "geometry/planar/region.h"

namespace blossom::planar {

/// A point that a spline passes, and the unit direction in which it does.
struct DirectedPoint {
  Vec2 at, along;
};

/// A cubic spline through points, smooth in direction, of as few pieces as keep within `tolerance` of all points. The
/// handles are those of a circular arc between two points. @pre at least two points that differ from their neighbours. O(n
/// log n)
Spline2 splineThrough(const std::vector<DirectedPoint>&, double tolerance);

/// Whether the piece that such a spline would have between two points keeps within a distance of places beside it. O(places)
bool keepsNear(const DirectedPoint& from, const DirectedPoint& to, std::span<const Vec2> places, double within);

}  // namespace blossom::planar
