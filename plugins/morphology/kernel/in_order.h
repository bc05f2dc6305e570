#pragma once
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// The same faces in an order that depends only on positions, not on indices: each face begins with its lowest corner, and
/// vertices are numbered by their positions. O(n log n).
Mesh inOrder(const Mesh&);

}  // namespace blossom::morphology
