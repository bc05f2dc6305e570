#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/polygons.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// Curves and points of a room that is nowhere wide there.
struct ThinRoom {
  std::vector<Path> curves;  ///< of lines and arcs; a ring is closed
  std::vector<Vec2> points;
};

/// By what a shape is grown on all sides to find the room in it that has no width.
struct Widening {
  double slack = 0;
  bool curved = false;  ///< whether a shape has curves: without any the room has lines alone
};

/// What has no width of a room, found in the same room made a little wider: what is narrower there than a few times the
/// slack, as its middle line. Corners that lie close together become one, edges run through the corners beside them, and an
/// edge that then leads both ways is a curve. Exact to about the slack.
/// @param loose the room when the shape around it is grown
/// @param room the room itself, regularised: what is narrow in it is no curve
/// O(n^2) for n corners. @throws Error Cancelled
ThinRoom thinParts(const Polygons& loose, const Region& room, const Widening&, const Progress& = Progress::none());

}  // namespace blossom::planar
