#pragma once
#include <cstddef>
#include <vector>

#include "core/vector.h"
#include "geometry/numeric/boxes.h"

namespace blossom::planar {

/// A closed polygon; the first point is not repeated at the end.
using Loop = std::vector<Vec2>;

/// A connected part: the outer loop counter-clockwise, holes clockwise.
struct Polygon {
  Loop outer;
  std::vector<Loop> holes;
};

/// A planar set bounded by straight edges, the operand and result of sums. No polygons: the empty set.
using Polygons = std::vector<Polygon>;

/// The order of points from left to right, those above one another upwards.
inline bool fartherLeft(const Vec2& p, const Vec2& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); }

/// Area to the left of a loop, negative when clockwise.
double signedArea(const Loop&);
double perimeter(const Loop&);
double area(const Polygons&);
/// Number of edges of all loops.
std::size_t edgeCount(const Polygons&);
/// s A, about the origin of the document. A negative s also turns by 180 degrees; s = 0 is not allowed.
Polygons scaled(const Polygons&, double s);
Polygons translated(const Polygons&, const Vec2& by);
/// Whether there is one part, without holes and without a right turn beyond rounding (1e-9 of the lengths of the edges).
bool isConvex(const Polygons&);

/// Around everything; empty when there is nothing.
Box2 boxOf(const Polygons&);

}  // namespace blossom::planar
