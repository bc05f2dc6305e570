#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/bspline/surface.h"
#include "geometry/shape/motion_edit.h"

namespace blossom::sweep {

/// A place at which the quaternions of an orientation vanish, where there is no rotation: |r| falls below 1e-6 of its
/// largest pole. Patches whose control points lie on one side of the origin need no further test; others are split, so only
/// the neighbourhood of a zero takes time.
/// @throws Error Cancelled.
std::optional<MotionPlace> vanishingPlace(const Surface& orientation, const Progress& = Progress::none());

/// Checks that there is none. @throws Error Degenerate that names (u, v); Cancelled.
void requireNonVanishing(const Surface& orientation, const Progress& = Progress::none());

}  // namespace blossom::sweep
