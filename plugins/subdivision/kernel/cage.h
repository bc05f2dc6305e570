#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/scheme.h"

namespace blossom::subdivision {

/// Whether a mesh can be the cage of a subdivision surface: faces with vertices that differ, at most two of them at an edge
/// and one fan of them round a vertex, all turned alike, no vertex without a face, numbers that are finite, tags that name
/// edges that exist; triangles only for Loop. O(n log n).
/// @throws Error InvalidInput that names the vertex, edge or face (counted from 1), Cancelled.
void checkCage(const Mesh&, Scheme, const Progress& = Progress::none());

}  // namespace blossom::subdivision
