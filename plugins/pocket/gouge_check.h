#pragma once
#include "geometry/shape/toolpath.h"
#include "kernel/check/simulate.h"

namespace blossom::pocket {

/// Measures programs against a part whose drawing has its zero, at the part's top, at `zero` of the programs' coordinates.
GougeOf gougeOf(Region part, const Vec3& zero, const SimulationOptions&);

}  // namespace blossom::pocket
