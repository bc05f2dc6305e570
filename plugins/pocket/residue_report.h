#pragma once
#include "feature/feature_type.h"
#include "geometry/shape/toolpath.h"
#include "kernel/check/simulate.h"

namespace blossom::pocket {

/// Marks what the tool could reach and its program leaves, and tells the area and a place in a warning.
/// @param place where the part's zero lies, and the height of the marks
void reportResidue(const SimulationResult&, const Vec3& place, Toolpath&, Evaluated&);

}  // namespace blossom::pocket
