#pragma once
#include <array>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom {

/// Clips a polygon of many corners ear by ear: about O(n log n), because only reflex corners near an ear are looked at. Of a
/// polygon that crosses itself, and so runs out of ears, the most convex corners go first.
/// Source: Held, "FIST: fast industrial-strength triangulation of polygons", 2001. @throws Error Cancelled.
/// @param nothing a corner so close to an ear hinders it, and an ear so flat is none, as long as there are others
std::vector<std::array<int, 3>> triangulateLarge(const std::vector<Vec2>& corners, double nothing, const Progress&);

}  // namespace blossom
