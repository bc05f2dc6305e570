#pragma once
#include "core/progress.h"
#include "geometry/bspline/surface.h"

namespace blossom::sweep {

/// Checks that the quaternions of an orientation stay away from zero, where there is no rotation. Patches whose control
/// points lie on one side of the origin need no further test; others are split, so only the neighbourhood of a zero takes
/// time.
/// @throws Error Degenerate that names (u, v) when |r| falls below 1e-6 of its largest pole; Cancelled.
void requireNonVanishing(const Surface& orientation, const Progress& = Progress::none());

}  // namespace blossom::sweep
