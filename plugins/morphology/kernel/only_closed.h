#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// Whether rounding has closed what was open and lost nothing: of the whole no more area than strips along its edges, as
/// wide as corners have moved, and no open part but those thinner than that. O(n log n)
/// @param before, after triangles
bool isOnlyClosed(const Mesh& before, const Mesh& after, double moved, const Progress&);

}  // namespace blossom::morphology
