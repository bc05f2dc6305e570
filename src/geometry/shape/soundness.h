#pragma once
#include <string>

#include "geometry/shape/shape.h"

namespace blossom {

/// Why a shape cannot be used at all, as a clause such as "point 4 is not a number" or "loop 2 has no segments"; empty when
/// the shape is sound. Checks what every algorithm requires (finite coordinates, indices in range, knots that match the
/// poles, positive weights), not what only some require (closed, no crossings). O(n).
std::string unsoundness(const Shape&);

}  // namespace blossom
