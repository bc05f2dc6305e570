#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// The same closed triangles without shells whose two sides are nearer to each other than a step, on average over their
/// area: rounding may have turned them inside out. A single shell is kept, and all are when the step is 0. O(n log n).
Mesh withoutSlivers(Mesh triangles, double step, const Progress&);

}  // namespace blossom::morphology
