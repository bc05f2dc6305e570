#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/shape/shape.h"

namespace blossom::subdivision {

/// Points that stand for a target: the vertices of a mesh; about `count` points evenly along curves, first to last.
/// @throws Error InvalidInput when there is none or more than 20,000, Cancelled.
std::vector<Vec3> samplesOf(const Shape& target, int count, const Progress& = Progress::none());

}  // namespace blossom::subdivision
