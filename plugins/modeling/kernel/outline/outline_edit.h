#pragma once
#include <optional>

#include "kernel/outline/outline_drawn.h"

namespace blossom::modeling {

/// A point of a drawn outline that can be moved. `segment` is -1 for the first point of all; `through` is -1 for the end of
/// its segment, else the place among the points that the segment passes.
struct OutlineHandle {
  int segment = -1;
  int through = -1;
  Vec2 at = Vec2::Zero();
  friend bool operator==(const OutlineHandle&, const OutlineHandle&) = default;
};

/// All of them; the last point of an outline that comes back to its start is its start.
std::vector<OutlineHandle> handlesOf(const DrawnOutline&);

/// With a point moved. Arcs through a point keep their shape when one of their ends moves. May be no proper outline.
DrawnOutline moved(const DrawnOutline&, const OutlineHandle&, const Vec2& to);
/// Without a point: corners join what is before to what comes after, arcs become lines, splines lose a point on their way.
/// Nothing when too little would be left.
std::optional<DrawnOutline> without(const DrawnOutline&, const OutlineHandle&);

/// The place of an outline nearest to a point.
struct OutlinePlace {
  int segment = 0;  ///< the number of segments: the line that closes the outline
  Vec2 at = Vec2::Zero();
  double distance = 0;
  int piece = 0;  ///< of a spline: between which of its points, counted from 0
};
std::optional<OutlinePlace> nearestPlace(const DrawnOutline&, const Vec2&);
/// With a further point there; lines and arcs become two, with the same curve; a spline passes the point as well.
DrawnOutline withPointAt(const DrawnOutline&, const OutlinePlace&);

/// Where the segment that ends in a point begins: guides start there while the point is moved.
std::optional<Vec2> pointBefore(const DrawnOutline&, const OutlineHandle&);

}  // namespace blossom::modeling
