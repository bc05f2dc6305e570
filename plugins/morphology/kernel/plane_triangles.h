#pragma once
#include <array>
#include <vector>

#include "core/vector.h"

namespace blossom::morphology {

/// Triangles of what lies between loops of points in a plane (to the left of each loop seen against `normal`), as indices of
/// `points`: a constrained Delaunay triangulation without further points. Nothing when loops cross.
std::vector<std::array<int, 3>> trianglesBetween(const std::vector<Vec3>& points, const std::vector<std::vector<int>>& loops,
                                                 const Vec3& normal);

}  // namespace blossom::morphology
