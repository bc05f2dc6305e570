#pragma once
#include "geometry/planar/region.h"
#include "geometry/shape/brep.h"

namespace blossom {

/// The area of flat faces that lie square to z at one height (which is dropped), with their holes; lines, circles and
/// B-splines stay what they are.
/// @throws Error InvalidInput for a solid, or faces that are curved, tilted or at several heights: each names the place.
Region toRegion(const Brep&);

}  // namespace blossom
