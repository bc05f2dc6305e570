#pragma once
#include <vector>

#include "geometry/planar/region.h"

namespace blossom::modeling {

enum class DrawnKind { Line, Arc, Spline };

/// One segment of a drawn outline, from the end of the segment before it.
struct DrawnSegment {
  DrawnKind kind = DrawnKind::Line;
  Vec2 to = Vec2::Zero();
  std::vector<Vec2> through;  ///< of an arc that is not tangent: one point on it; of a spline: its interior points
  bool tangent = false;       ///< of arcs and splines: continues the end direction of the segment before
  friend bool operator==(const DrawnSegment&, const DrawnSegment&) = default;
};

/// An outline as drawn and edited. A closed outline that does not return to its start is closed by a line, or, when it is a
/// single spline, smoothly.
struct DrawnOutline {
  Vec2 start = Vec2::Zero();
  std::vector<DrawnSegment> segments;
  bool closed = false;
  friend bool operator==(const DrawnOutline&, const DrawnOutline&) = default;
};

/// The exact curves: lines, circular arcs, cubic splines. @throws Error InvalidInput naming the segment when it has no
/// length, an arc is not determined by its points, or the first segment is tangent.
Path toPath(const DrawnOutline&);
/// Whether the points determine the outline, that is, toPath does not throw.
bool isSound(const DrawnOutline&);
/// The curve of segment k, for previews of incomplete outlines. @throws as toPath, for segments 0..k.
Segment segmentOf(const DrawnOutline&, std::size_t k);
/// Unit tangent at the start, and at the end of a segment.
Vec2 startDirection(const Segment&);
Vec2 endDirection(const Segment&);

/// The circular arc from a to b through a point; a full circle when b is a, a line when the point lies between them.
/// @throws Error Degenerate when no circle passes through the three.
Segment arcThrough(const Vec2& a, const Vec2& via, const Vec2& b);
/// The circular arc that starts at a in a direction and ends at b; a line when b lies straight ahead.
/// @throws Error Degenerate when b is a or lies straight behind.
Segment tangentArc(const Vec2& a, const Vec2& direction, const Vec2& b);
/// The middle of an arc of at most a half circle from a to b with that radius, on the side of `towards`. A radius that is
/// too small is raised to half the distance.
Vec2 middleOfArc(const Vec2& a, const Vec2& b, double radius, const Vec2& towards);

}  // namespace blossom::modeling
