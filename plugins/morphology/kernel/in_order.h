#pragma once
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// The same faces in an order that their places alone decide, whatever numbers they had: each begins with its lowest corner,
/// and vertices are numbered by their places. O(n log n).
Mesh inOrder(const Mesh&);

}  // namespace blossom::morphology
