#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/planar/polygons/polygons.h"

/// How far the boundaries of two sets lie apart.
namespace blossom::test {

using Sides = std::vector<std::pair<Vec2, Vec2>>;

inline Sides sidesOf(const planar::Polygons& polygons) {
  Sides sides;
  const auto add = [&](const planar::Loop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) sides.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
  };
  for (const planar::Polygon& polygon : polygons) {
    add(polygon.outer);
    for (const planar::Loop& hole : polygon.holes) add(hole);
  }
  return sides;
}

inline double distanceFrom(const Sides& sides, const Vec2& p) {
  double nearest = HUGE_VAL;
  for (const auto& [a, b] : sides) {
    const Vec2 along = b - a;
    const double t = std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - t * along).norm());
  }
  return nearest;
}

/// Of the corners of each from the other: 0 when both are empty, infinite when one is.
inline double distanceBetween(const Sides& first, const Sides& second) {
  double farthest = first.empty() == second.empty() ? 0 : HUGE_VAL;
  for (const auto& [a, b] : first) farthest = std::max(farthest, distanceFrom(second, a));
  for (const auto& [a, b] : second) farthest = std::max(farthest, distanceFrom(first, a));
  return farthest;
}

}  // namespace blossom::test
