#pragma once
#include <array>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/planar/region.h"

namespace blossom {

/// Triangles of a planar area, counter-clockwise.
struct AreaTriangles {
  std::vector<Vec2> points;  ///< the corners of the polygons, and the places where their sides cross
  std::vector<std::array<int, 3>> triangles;
};

/// Constrained Delaunay triangulation of the area that closed polygons enclose by a fill rule. The polygons may touch,
/// overlap and cross. About O(n log n) for sides that do not cross. Predicates of the triangulation are exact; a place where
/// sides cross is rounded. @throws Error Cancelled.
AreaTriangles triangulateArea(const std::vector<std::vector<Vec2>>& polygons, const Progress&, FillRule = FillRule::EvenOdd);

}  // namespace blossom
