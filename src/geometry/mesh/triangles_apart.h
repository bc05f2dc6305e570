#pragma once
#include <cstddef>

#include "geometry/mesh/triangle_distance.h"

/// Inside of crossingElsewhere: what doubles can tell about two triangles in spite of their rounding. "True" is certain;
/// "false" means that exact numbers have to be asked. Most pairs of a mesh are neighbours in one plane, about which the
/// exact predicates have no quick answer.
namespace blossom {

/// A plane lies between them.
bool areApart(const Triangle3& a, const Triangle3& b);
/// They have one corner in common, and a plane through it lies between the rest of them.
bool areApartBeyondCorner(const Triangle3& a, const Triangle3& b, std::size_t cornerOfA, std::size_t cornerOfB);
/// Seen along the line from `p` to `q`, the half planes from it through `x` and `y` are more than a right angle apart.
bool lieAcross(const Vec3& p, const Vec3& q, const Vec3& x, const Vec3& y);

}  // namespace blossom
