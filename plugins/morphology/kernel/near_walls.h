#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// A place where bodies touch in faces that rounding has put next to each other: within `near`, but not in one plane
/// exactly. Between such faces there are cracks and overlaps as thin as rounding. Faces across an axis, which share a
/// coordinate, are exact. O(n log n) for n triangles that are spread well.
std::optional<Vec3> firstNearWall(const Mesh& triangles, const std::vector<int>& bodyOfFace, double near, const Progress&);

}  // namespace blossom::morphology
