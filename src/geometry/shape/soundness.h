#pragma once
#include <string>

#include "geometry/shape/shape.h"

namespace blossom {

/// What keeps a shape from being used at all, as a clause such as "point 4 is not a number" or "loop 2 has no segments";
/// empty when there is nothing. Looks at what every algorithm takes for granted (finite coordinates, indices in range, knots
/// that fit their poles, positive weights), not at what only some need (closed, without crossings). O(n).
std::string unsoundness(const Shape&);

}  // namespace blossom
