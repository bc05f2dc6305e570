#pragma once
#include <algorithm>
#include <vector>

#include "support/polyhedra.h"

/// Whether a point lies in a sum, decided without any sum.
namespace blossom::test {

/// Whether the segment passes through the triangle, in general position.
inline bool pierces(const Vec3& p, const Vec3& q, const std::vector<Vec3>& t) {
  const auto side = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (b - a).cross(c - a).dot(d - a) > 0;
  };
  if (side(t[0], t[1], t[2], p) == side(t[0], t[1], t[2], q)) return false;
  const bool first = side(p, q, t[0], t[1]);
  return side(p, q, t[1], t[2]) == first && side(p, q, t[2], t[0]) == first;
}

inline bool trianglesCross(const std::vector<Vec3>& s, const std::vector<Vec3>& t) {
  for (std::size_t k = 0; k < 3; ++k)
    if (pierces(s[k], s[(k + 1) % 3], t) || pierces(t[k], t[(k + 1) % 3], s)) return true;
  return false;
}

/// Whether two solids of triangles meet: their surfaces cross, or a corner of one lies in the other.
inline bool meet(const Mesh& a, const Mesh& b) {
  for (std::size_t f = 0; f < a.faceCount(); ++f)
    for (std::size_t g = 0; g < b.faceCount(); ++g)
      if (trianglesCross(facePoints(a, f), facePoints(b, g))) return true;
  const auto anyHeld = [](const Mesh& solid, const Mesh& other) {
    return std::any_of(other.points.begin(), other.points.end(), [&](const Vec3& p) { return contains(solid, p); });
  };
  return anyHeld(a, b) || anyHeld(b, a);
}

}  // namespace blossom::test
