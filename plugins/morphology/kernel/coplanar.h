#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

struct CoplanarOptions {
  double tolerance = 0;  ///< mm, maximum distance of a vertex from its plane or straight edge
};

/// The same closed surface with coplanar neighbouring triangles joined to polygons and vertices inside straight edges
/// removed. Faces with holes, or that touch themselves, are divided into a few triangles. What cannot be joined without
/// damage is unchanged. O(n log n).
Mesh joinedCoplanar(const Mesh& triangles, const CoplanarOptions&, const Progress& = Progress::none());

}  // namespace blossom::morphology
