#include "kernel/grid.h"

#include <algorithm>
#include <cmath>

namespace blossom::minkowski {
namespace {

GridLoop snapped(const Loop& loop, const Grid& grid) {
  GridLoop points;
  points.reserve(loop.size());
  for (const Vec2& p : loop) {
    const Vec2 q = (p - grid.origin) / grid.unit;
    points.push_back({std::llround(q.x()), std::llround(q.y())});
  }
  return cleaned(points);
}

}  // namespace

/// What one removal makes straight is found by stepping back.
GridLoop cleaned(const GridLoop& loop) {
  GridLoop kept;
  const auto turns = [](const GridPoint& a, const GridPoint& b, const GridPoint& c) { return cross(b - a, c - b) != 0; };
  for (const GridPoint& p : loop) {
    while (kept.size() >= 2 && !turns(kept[kept.size() - 2], kept.back(), p)) kept.pop_back();
    if (kept.empty() || kept.back() != p) kept.push_back(p);
  }
  // The seam between the last and the first point.
  for (std::size_t first = 0; kept.size() - first >= 3;) {
    const std::size_t n = kept.size();
    if (!turns(kept[n - 2], kept[n - 1], kept[first]))
      kept.pop_back();
    else if (!turns(kept[n - 1], kept[first], kept[first + 1]))
      ++first;
    else
      return {kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end()};
  }
  return {};
}

double gridUnit(const Vec2& largestSize) {
  constexpr int bits = 39;  // from the middle of a box to its sides, with one bit to spare
  int exponent = 0;
  std::frexp(std::max(largestSize.maxCoeff() / 2, 1e-200), &exponent);
  return std::ldexp(1.0, exponent - bits);
}

std::vector<GridPolygon> snapped(const Polygons& polygons, const Grid& grid) {
  std::vector<GridPolygon> result;
  for (const Polygon& polygon : polygons) {
    GridPolygon image{snapped(polygon.outer, grid), {}};
    if (image.outer.empty()) continue;
    for (const Loop& hole : polygon.holes)
      if (GridLoop loop = snapped(hole, grid); !loop.empty()) image.holes.push_back(std::move(loop));
    result.push_back(std::move(image));
  }
  return result;
}

}  // namespace blossom::minkowski
