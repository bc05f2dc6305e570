#pragma once
#include "feature/feature_type.h"
#include "geometry/shape/toolpath.h"
#include "kernel/check/simulate.h"

namespace blossom::pocket {

/// Marks the residue of a program, and adds a warning with its area and a place.
/// @param place position of the part's zero, and height of the marks
void reportResidue(const SimulationResult&, const Vec3& place, Toolpath&, Evaluated&);

}  // namespace blossom::pocket
