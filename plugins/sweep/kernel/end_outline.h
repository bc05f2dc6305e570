#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/bspline/surface.h"

namespace blossom::sweep {

/// A point at which the flat outline at an end in v of a surface that closes in u must cross or cover itself, or nothing
/// where that cannot be told. A closed outline without crossings turns once around (Hopf's Umlaufsatz); one that turns
/// another number of times, as a figure eight or a circle that is run through twice, crosses itself. An outline that crosses
/// itself and turns once, or has a corner of nearly half a turn, is not told. mm; O(samples), squared where it crosses.
/// @param normal of the plane of the outline  @throws Error Cancelled
std::optional<Vec3> outlineCrossing(const Surface&, bool atEnd, const Vec3& normal, const Progress& = Progress::none());

}  // namespace blossom::sweep
