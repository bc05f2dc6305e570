#pragma once
#include <array>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom {

/// Triangulates a polygon with many corners by ear clipping, in about O(n log n) because only reflex corners near an ear are
/// tested. When a polygon that crosses itself has no ear left, the most convex corner is clipped.
/// Source: Held, "FIST: fast industrial-strength triangulation of polygons", 2001. @throws Error Cancelled.
/// @param nothing distance below which a corner near an ear blocks it, and height below which an ear counts as flat and is
/// clipped last
std::vector<std::array<int, 3>> triangulateLarge(const std::vector<Vec2>& corners, double nothing, const Progress&);

}  // namespace blossom
