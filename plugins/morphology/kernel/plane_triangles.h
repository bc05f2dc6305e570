#pragma once
#include <array>
#include <vector>

#include "core/vector.h"

namespace blossom::morphology {

/// Triangles of the area between loops of coplanar points (to the left of each loop seen against `normal`), as indices of
/// `points`: a constrained Delaunay triangulation without additional points. Empty when loops cross.
std::vector<std::array<int, 3>> trianglesBetween(const std::vector<Vec3>& points, const std::vector<std::vector<int>>& loops,
                                                 const Vec3& normal);

}  // namespace blossom::morphology
