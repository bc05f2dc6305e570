#pragma once
#include <span>

#include "geometry/numeric/boxes.h"
#include "geometry/planar/region.h"

namespace blossom {

/// The least box around a line or an arc, up to rounding; around the poles of a spline.
Box2 boxAround(const Segment&);
Box2 boxAround(std::span<const Path>);

}  // namespace blossom
