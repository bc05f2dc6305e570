#pragma once
#include <optional>
#include <vector>

#include "geometry/planar/region.h"

namespace blossom::modeling {

/// What a point of a drawing was caught by, weakest first.
enum class SnapKind {
  None,
  Grid,           ///< a crossing of grid lines, or one grid line met by a guide
  OnCurve,        ///< the nearest point of a line or arc
  Horizontal,     ///< guides through the last point ..
  Vertical,       ///<
  Diagonal,       ///< .. at 45 degrees
  Aligned,        ///< level with, or plumb below or above, the first point
  Tangent,        ///< straight on from the last segment
  Square,         ///< at right angles to the last segment
  Crossing,       ///< of two guides
  Perpendicular,  ///< foot of the perpendicular from the last point onto a line or arc
  Midpoint,
  Centre,
  Point,
  Start  ///< first point of the drawing
};

struct SnapPoint {
  Vec2 at = Vec2::Zero();
  SnapKind kind = SnapKind::Point;
};

/// What there is to catch the mouse.
struct SnapScene {
  std::vector<SnapPoint> points;
  std::vector<Segment> curves;  ///< lines and arcs are used
};

struct SnapQuery {
  Vec2 mouse = Vec2::Zero();
  double reach = 0;               ///< mm within which the mouse is caught
  double grid = 0;                ///< mm between grid lines; 0: no grid
  std::optional<Vec2> from;       ///< where the segment that is being drawn begins
  std::optional<Vec2> direction;  ///< in which the segment before arrives there
  std::optional<Vec2> start;      ///< first point of the drawing, to align with
};

/// A straight help line through a point, shown while the mouse is caught by it.
struct Guide {
  Vec2 origin = Vec2::Zero();
  Vec2 direction = Vec2::UnitX();  ///< unit length
  SnapKind kind = SnapKind::Horizontal;
};

struct Snap {
  Vec2 point = Vec2::Zero();
  SnapKind kind = SnapKind::None;
  std::vector<Guide> guides;  ///< that hold the point
};

/// The point that is meant by the mouse: the nearest thing of the strongest sort within reach (points, feet of
/// perpendiculars, crossings of guides, guides, curves, grid), else the mouse itself. O(points + curves).
Snap snapped(const SnapScene&, const SnapQuery&);

/// Points and curves of drawn shapes: ends, middles and centres. Splines give their ends alone.
void addToScene(SnapScene&, const Path&);

}  // namespace blossom::modeling
