#pragma once
#include "geometry/shape/toolpath.h"
#include "kernel/check/simulate.h"

namespace blossom::pocket {

/// Measures programs against a part. `zero` is the position of the drawing's zero, at the part's top, in the coordinates of
/// the programs.
GougeOf gougeOf(Region part, const Vec3& zero, const SimulationOptions&);

}  // namespace blossom::pocket
