#pragma once
#include <optional>
#include <vector>

#include "geometry/planar/region.h"

namespace blossom::modeling {

/// Object that a point was snapped to, weakest first.
enum class SnapKind {
  None,
  Grid,           ///< a crossing of grid lines, or of a grid line and a guide
  OnCurve,        ///< the nearest point of a line or arc
  Horizontal,     ///< guides through the last point ..
  Vertical,       ///<
  Diagonal,       ///< .. at 45 degrees
  Aligned,        ///< horizontally or vertically aligned with the first point
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

/// The objects to snap to.
struct SnapScene {
  std::vector<SnapPoint> points;
  std::vector<Segment> curves;  ///< lines and arcs are used
};

struct SnapQuery {
  Vec2 mouse = Vec2::Zero();
  double reach = 0;               ///< mm, snapping distance
  double grid = 0;                ///< mm between grid lines; 0: no grid
  std::optional<Vec2> from;       ///< start of the segment that is being drawn
  std::optional<Vec2> direction;  ///< end direction of the segment before
  std::optional<Vec2> start;      ///< first point of the drawing, to align with
};

/// A construction line through a point, shown while the mouse is snapped to it.
struct Guide {
  Vec2 origin = Vec2::Zero();
  Vec2 direction = Vec2::UnitX();  ///< unit length
  SnapKind kind = SnapKind::Horizontal;
};

struct Snap {
  Vec2 point = Vec2::Zero();
  SnapKind kind = SnapKind::None;
  std::vector<Guide> guides;  ///< guides through the point
};

/// The snapped point: the nearest object of the strongest kind within reach (points, feet of perpendiculars, crossings of
/// guides, guides, curves, grid), else the mouse itself. O(points + curves).
Snap snappedPoint(const SnapScene&, const SnapQuery&);

/// Adds points and curves of drawn shapes: ends, midpoints and centres; of splines only the ends.
void addToScene(SnapScene&, const Path&);

}  // namespace blossom::modeling
