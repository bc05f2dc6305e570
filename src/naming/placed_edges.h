#pragma once
#include <functional>
#include <vector>

#include "core/vector.h"
#include "geometry/shape/shape.h"

namespace blossom {

/// Distance in mm from a point to a curve.
using DistanceTo = std::function<double(const Vec3&)>;

/// The edges of a B-rep, the segments of a drawing in z = 0 or a curve in space, in the order of their numbers
/// (geometry/occt/sub_shape.h); none of other kinds.
/// @param size of the shape in mm, by which free-form segments are flattened
std::vector<DistanceTo> distancesToEdges(const Shape&, double size);

}  // namespace blossom
