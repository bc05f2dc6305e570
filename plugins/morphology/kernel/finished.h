#pragma once
#include <string>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// A result with corners rounded to doubles.
struct Finished {
  Mesh mesh;            ///< closed polygons in the user's coordinates; the exact test finds no intersections
  std::string warning;  ///< when corners had to be moved by more than rounding
};

/// Closed, oriented triangles about `centre` as polygons: coplanar triangles are joined, vertices inside straight edges
/// removed (see joinedFacesFlatness). Where rounding makes faces intersect, fewer are joined; where they still do, corners
/// are rounded to coarser and coarser grids. The same solid always results in the same mesh, however it was triangulated.
/// @throws Error Degenerate with the place when faces intersect on every grid, Internal, Cancelled.
Finished finished(const Mesh& triangles, const Vec3& centre, const Progress&);

}  // namespace blossom::morphology
