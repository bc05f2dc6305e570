#pragma once
#include <string>

#include "core/vector.h"

namespace blossom {

/// Coordinates of a point as messages print them: "(1, 2.5, -3)", in mm with six digits; values within 1e-9 mm of 0,
/// or 1e-8 of the largest coordinate, are printed as 0.
std::string placeText(const Vec3&);

/// The same with no more digits than help to find the place in a thing of this size: rounded to the power of ten in which
/// the size, in mm, has its last one of `digits`.
std::string placeText(const Vec3&, double size, int digits);

/// A number for "at least ..", with two digits: never more than the value, which is above 0.
std::string leastText(double);

}  // namespace blossom
