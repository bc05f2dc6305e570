#pragma once
#include <TopoDS_Shape.hxx>
#include <vector>

#include "core/progress.h"
#include "geometry/tessellate/tessellate.h"

namespace blossom {

/// Where the points of a tessellated shape lie on it, one entry for each of Tessellation::points.
struct PointOrigins {
  std::vector<Vec2> parameters;  ///< on the surface of their face
  std::vector<int>
      joint;  ///< the first point that is the same one by an edge or a vertex of the shape, else the point itself
};

/// Triangles of one OCCT shape with its edges and vertices, all numbered in the order of TopExp::MapShapes. Points on an
/// edge have the same coordinates in all adjacent faces, so that the triangles of a closed shell are closed. Meshes a copy:
/// the shape itself gets no triangulation and may be read by other threads meanwhile.
/// @param origins where given, is filled in
/// @throws Error Degenerate when no face can be triangulated, Cancelled.
Tessellation meshShape(const TopoDS_Shape&, const TessellationOptions&, const Progress&, PointOrigins* origins = nullptr);

}  // namespace blossom
