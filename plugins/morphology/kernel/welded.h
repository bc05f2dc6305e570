#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// The vertices of a face from the lowest number on, so that equal faces read alike.
std::vector<int> fromLowest(std::vector<int> face);

/// Faces that use the same place use the same vertex, and no face uses one twice in a row. O(n) for n corners.
Mesh withSharedPoints(const Mesh&, const Progress&);

/// Bodies that share a whole face are one body: the face and its counterpart, which looks back at it, enclose nothing. O(n)
/// @param mesh with shared points
Mesh withoutInnerWalls(const Mesh& mesh, const Progress&);

}  // namespace blossom::morphology
