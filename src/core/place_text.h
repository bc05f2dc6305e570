#pragma once
#include <string>

#include "core/vector.h"

namespace blossom {

/// Coordinates of a point as messages print them: "(1, 2.5, -3)", in mm with six digits; values within 1e-9 mm of 0 are
/// printed as 0.
std::string placeText(const Vec3&);

/// A number for "at least ..", with two digits: never more than the value, which is above 0.
std::string leastText(double);

}  // namespace blossom
