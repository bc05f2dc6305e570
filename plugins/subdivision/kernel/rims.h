#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/scheme.h"

namespace blossom::subdivision {

struct JoinedRims {
  Mesh mesh;
  std::size_t joined = 0;  ///< vertices that became one with another
};

/// Edges of the rim that run along each other, one there and one back, within 1e-9 of the size, become one edge: halves that
/// were mirrored, or seams that a file keeps apart, close. Edges at which more than two would meet stay as they are, and so
/// do vertices that touch without such an edge. Of two vertices the one with the lower number keeps its place. O(n log n).
/// @throws Error InvalidInput when a face names a vertex that does not exist, Cancelled.
JoinedRims joinRims(const Mesh&, const Progress& = Progress::none());

/// The same where the result is a cage that `checkCage` accepts; else the mesh as it is.
JoinedRims joinedCage(const Mesh&, Scheme, const Progress& = Progress::none());

}  // namespace blossom::subdivision
