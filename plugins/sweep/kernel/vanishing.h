#pragma once
#include "core/progress.h"
#include "geometry/bspline/surface.h"

namespace blossom::sweep {

/// Where the quaternions of an orientation come nearest to zero there is no rotation. Patches whose control points keep to
/// one side of the origin are settled at once; others are split, so only the neighbourhood of a zero costs time.
/// @throws Error Degenerate that names (u, v) when |r| falls below 1e-6 of its largest pole; Cancelled.
void requireNonVanishing(const Surface& orientation, const Progress& = Progress::none());

}  // namespace blossom::sweep
