#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom {

/// As `triangulate` in geometry/mesh/mesh_topology.h, for polygons of unknown size, such as those of a file. About O(n log
/// n) where the polygon does not cross itself. @throws Error Cancelled.
std::vector<std::array<int, 3>> triangulate(std::span<const Vec3> polygon, const Progress&);

}  // namespace blossom
