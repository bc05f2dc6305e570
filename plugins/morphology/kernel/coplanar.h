#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

struct CoplanarOptions {
  double tolerance = 0;  ///< mm, how far a vertex may lie from the plane or the straight edge it is taken for
};

/// The same closed surface with neighbouring triangles of one plane joined to polygons, and vertices within straight edges
/// left out. Faces with holes, or that touch themselves, become triangles again, but few. What cannot be joined without
/// harm stays as it is. O(n log n).
Mesh joinedCoplanar(const Mesh& triangles, const CoplanarOptions&, const Progress& = Progress::none());

}  // namespace blossom::morphology
