#pragma once
#include <cstddef>
#include <vector>

#include "core/vector.h"
#include "geometry/numeric/boxes.h"

namespace blossom::minkowski {

/// A closed polygon; the first point is not repeated at the end.
using Loop = std::vector<Vec2>;

/// A connected part: the outer loop counter-clockwise, holes clockwise.
struct Polygon {
  Loop outer;
  std::vector<Loop> holes;
};

/// A planar set bounded by straight edges: what every sum takes and gives. Empty: the empty set.
using Polygons = std::vector<Polygon>;

/// Area to the left of a loop, negative when clockwise.
double signedArea(const Loop&);
double area(const Polygons&);
/// Edges of all loops together.
std::size_t edgeCount(const Polygons&);
/// s A, about the origin of the document; s below 0 turns by half a turn, 0 is not allowed.
Polygons scaled(const Polygons&, double s);
Polygons translated(const Polygons&, const Vec2& by);
/// One part without holes and without a right turn beyond rounding (1e-9 of the edges' lengths).
bool isConvex(const Polygons&);

/// Around everything; empty when there is nothing.
Box2 boxOf(const Polygons&);

}  // namespace blossom::minkowski
