#pragma once
#include "geometry/planar/region.h"
#include "geometry/shape/brep.h"

namespace blossom {

/// The region covered by planar faces perpendicular to z at one height (which is dropped), with their holes. Lines, circles
/// and B-splines keep their type.
/// @throws Error InvalidInput, with the place, for a solid and for faces that are curved, tilted or at several heights.
Region toRegion(const Brep&);

}  // namespace blossom
