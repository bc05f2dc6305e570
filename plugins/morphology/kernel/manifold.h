#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// The same faces with vertices duplicated where only corners or edges touch, so that the surface is a manifold as far as
/// that is possible without new vertices. At an edge with more than two faces, the two faces at each interior wedge are
/// connected. Unused vertices are removed. Faces must be oriented and traverse every edge equally often in both directions.
/// O(n log n).
Mesh manifoldOf(const Mesh&, const Progress& = Progress::none());

/// The same for triangles, with new vertices where needed: an edge whose ends are connected by other faces is divided in the
/// middle, once for each of its wedges.
Mesh manifoldOfTriangles(const Mesh& triangles, const Progress& = Progress::none());

}  // namespace blossom::morphology
