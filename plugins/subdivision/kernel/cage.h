#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/scheme.h"

namespace blossom::subdivision {

/// Checks that a mesh can be the cage of a subdivision surface: distinct vertices in each face, at most two faces per edge,
/// a single fan of faces around each vertex, consistent orientation, no unused vertices, finite coordinates, tags of
/// existing edges; triangles only for Loop. O(n log n).
/// @throws Error InvalidInput that names the vertex, edge or face (counted from 1), Cancelled.
void checkCage(const Mesh&, Scheme, const Progress& = Progress::none());

}  // namespace blossom::subdivision
