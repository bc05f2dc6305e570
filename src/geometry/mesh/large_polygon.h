#pragma once
#include <array>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom {

/// Whether the way to a corner comes back where it was, within some times what is insignificant.
bool isSpike(const Vec2& before, const Vec2& corner, const Vec2& after, double nothing);

/// Triangulates a polygon with many corners by ear clipping, in about O(n log n) because only reflex corners near an ear are
/// tested. Where rounding makes corners reach into every ear, those that do by a little do not block it; when a polygon that
/// crosses itself has no ear left then, the most convex corner is clipped.
/// Source: Held, "FIST: fast industrial-strength triangulation of polygons", 2001. @throws Error Cancelled.
/// @param nothing distance below which a corner near an ear blocks it, and height below which an ear counts as flat and is
/// clipped last
/// @param spikesFirst whether spikes (see isSpike) are clipped before all else
std::vector<std::array<int, 3>> triangulateLarge(const std::vector<Vec2>& corners, double nothing, bool spikesFirst,
                                                 const Progress&);

}  // namespace blossom
