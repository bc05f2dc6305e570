#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom {

/// For every point the index of the first point within `distance` of it. Chains of near points are merged only as far as
/// each is near the first. O(n).
std::vector<int> mergeClosePoints(std::span<const Vec3> points, double distance);

/// For every point the index of the first point with the same coordinates (0 and -0 are one). O(n).
/// @throws Error Cancelled.
std::vector<int> mergeEqualPoints(std::span<const Vec3> points, const Progress& = Progress::none());

}  // namespace blossom
