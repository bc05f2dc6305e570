#pragma once
#include <span>
#include <vector>

#include "core/vector.h"

namespace blossom {

/// For every point the index of the first point within `distance` of it. O(n).
/// Chains of near points become one only when each is near the first.
std::vector<int> mergeClosePoints(std::span<const Vec3> points, double distance);

}  // namespace blossom
