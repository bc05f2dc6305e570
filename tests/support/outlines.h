#pragma once
#include <array>
#include <utility>
#include <vector>

#include "geometry/planar/region.h"

/// Outlines of lines and cubics.
namespace blossom::test {

inline Spline2 cubic(const std::array<Vec2, 4>& poles) {
  Spline2 made{3, {0, 0, 0, 0, 1, 1, 1, 1}, {}};
  for (const Vec2& p : poles) made.poles.push_back(p.homogeneous());
  return made;
}

inline Path closedPath(std::vector<Segment> segments) { return {std::move(segments), true, {}, {}}; }

inline void appendLines(std::vector<Segment>& segments, const std::vector<Vec2>& points) {
  for (std::size_t k = 1; k < points.size(); ++k) segments.emplace_back(Line2{points[k - 1], points[k]});
}

}  // namespace blossom::test
