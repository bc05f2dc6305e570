#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/shape/shape.h"

namespace blossom::subdivision {

/// Sample points of a target: the vertices of a mesh; about `count` points at equal distances along curves, both ends
/// included.
/// @throws Error InvalidInput when there is none or more than 20,000, Cancelled.
std::vector<Vec3> samplesOf(const Shape& target, int count, const Progress& = Progress::none());

}  // namespace blossom::subdivision
