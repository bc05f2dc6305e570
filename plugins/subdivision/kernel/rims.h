#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/scheme.h"

namespace blossom::subdivision {

struct JoinedRims {
  Mesh mesh;
  std::size_t joined = 0;  ///< number of vertices merged into another
};

/// Merges boundary edges that coincide with opposite directions within 1e-9 of the size, so that mirrored halves, or seams
/// that a file keeps apart, are closed. Edges at which more than two would meet are unchanged, and so are vertices that
/// touch without such an edge. Of two vertices the one with the lower index keeps its position. O(n log n).
/// @throws Error InvalidInput for a vertex index out of range, Cancelled.
JoinedRims joinRims(const Mesh&, const Progress& = Progress::none());

/// The same if the result is a cage that `checkCage` accepts; else the mesh unchanged.
JoinedRims joinedCage(const Mesh&, Scheme, const Progress& = Progress::none());

}  // namespace blossom::subdivision
