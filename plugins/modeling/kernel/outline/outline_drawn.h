#pragma once
#include <vector>

#include "geometry/planar/region.h"

namespace blossom::modeling {

enum class DrawnKind { Line, Arc, Spline };

/// One stroke of a drawn outline; it begins where the one before ends.
struct DrawnSegment {
  DrawnKind kind = DrawnKind::Line;
  Vec2 to = Vec2::Zero();
  std::vector<Vec2> through;  ///< an arc: one point on it unless it is tangent; a spline: points it passes on its way
  bool tangent = false;       ///< arcs and splines: goes on in the direction in which the segment before arrives
  friend bool operator==(const DrawnSegment&, const DrawnSegment&) = default;
};

/// What a user draws and edits. A closed outline that does not come back to its start is closed by a line, unless it is one
/// spline: that is then smooth all round.
struct DrawnOutline {
  Vec2 start = Vec2::Zero();
  std::vector<DrawnSegment> segments;
  bool closed = false;
  friend bool operator==(const DrawnOutline&, const DrawnOutline&) = default;
};

/// The exact curves: lines, circular arcs, cubic splines. @throws Error InvalidInput naming the segment when it has no
/// length, an arc is not determined by its points, or a first segment is to be tangent to nothing.
Path toPath(const DrawnOutline&);
/// Whether its points determine the outline: toPath throws nothing.
bool isSound(const DrawnOutline&);
/// The curve of segment k alone, for a preview that shows what can be shown. @throws as above, for the segments 0..k.
Segment segmentOf(const DrawnOutline&, std::size_t k);
/// Unit direction in which a segment leaves its start, or arrives at its end.
Vec2 startDirection(const Segment&);
Vec2 endDirection(const Segment&);

/// The circular arc from a to b through a point; a full circle when b is a. A straight line when the point lies between
/// them.
/// @throws Error Degenerate when no circle passes through the three.
Segment arcThrough(const Vec2& a, const Vec2& via, const Vec2& b);
/// The circular arc that leaves a in a direction and ends at b; a straight line when b lies ahead.
/// @throws Error Degenerate when b is a or lies straight behind.
Segment tangentArc(const Vec2& a, const Vec2& direction, const Vec2& b);
/// The point in the middle of an arc from a to b with that radius, on the side of `towards` and no more than a half circle.
/// The radius is made large enough to reach.
Vec2 middleOfArc(const Vec2& a, const Vec2& b, double radius, const Vec2& towards);

}  // namespace blossom::modeling
