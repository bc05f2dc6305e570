#pragma once
#include <optional>

#include "kernel/outline/outline_drawn.h"

namespace blossom::modeling {

/// A movable point of a drawn outline. `segment` is -1 for the start of the outline; `through` is -1 for the end of the
/// segment, else an index in DrawnSegment::through.
struct OutlineHandle {
  int segment = -1;
  int through = -1;
  Vec2 at = Vec2::Zero();
  friend bool operator==(const OutlineHandle&, const OutlineHandle&) = default;
};

/// All handles. The end of an outline that returns to its start has none of its own.
std::vector<OutlineHandle> handlesOf(const DrawnOutline&);

/// The outline with a handle moved. Arcs through a point keep their shape when an end moves. The result may be unsound.
DrawnOutline moved(const DrawnOutline&, const OutlineHandle&, const Vec2& to);
/// The outline without a point: the segments at a corner are joined, arcs become lines, splines lose an interior point.
/// Empty when too little would be left.
std::optional<DrawnOutline> without(const DrawnOutline&, const OutlineHandle&);

/// The point of an outline nearest to a given point.
struct OutlinePlace {
  int segment = 0;  ///< index; the number of segments means the line that closes the outline
  Vec2 at = Vec2::Zero();
  double distance = 0;
  int piece = 0;  ///< of a spline: index of the interval between its points
};
std::optional<OutlinePlace> nearestPlace(const DrawnOutline&, const Vec2&);
/// The outline with a point inserted there. Lines and arcs are divided without a change of the curve; a spline gets an
/// interior point.
DrawnOutline withPointAt(const DrawnOutline&, const OutlinePlace&);

/// Start of the segment that ends in a handle; guides start there while the handle is moved.
std::optional<Vec2> pointBefore(const DrawnOutline&, const OutlineHandle&);

}  // namespace blossom::modeling
