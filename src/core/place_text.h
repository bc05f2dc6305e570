#pragma once
#include <string>

#include "core/vector.h"

namespace blossom {

/// A place as messages name it: "(1, 2.5, -3)", in mm to six digits; what lies within 1e-9 mm of 0 is written as 0.
std::string placeText(const Vec3&);

}  // namespace blossom
