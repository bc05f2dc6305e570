#pragma once
#include <QString>
#include <optional>
#include <vector>

#include "geometry/shape/shape.h"
#include "scene/picking.h"

namespace blossom::ui {

/// A place in space that the mouse snaps to.
struct SnapPlace {
  enum class Kind { Ground, Grid, Face, Edge, Midpoint, Centre, Point };
  Vec3 at = Vec3::Zero();
  Kind kind = Kind::Point;
};

/// Ends and middles (by length) of edges, and the centres of circles and ellipses; of outlines likewise; the points of
/// meshes. At most 100,000. O(edges).
std::vector<SnapPlace> snapPlaces(const Shape&);

struct SnapAim {
  Ray ray;                     ///< under the mouse
  double reach = 0;            ///< mm from the ray; 0: no snapping
  double grid = 0;             ///< mm between the lines of the grid on the ground
  std::optional<SubPick> hit;  ///< what the ray hits
};

/// The place that lies nearest to the ray within reach and is not hidden by what the ray hits; else where the ray hits
/// something, else the nearest crossing of the grid or the ground itself. Empty when the ray meets nothing. O(places).
std::optional<SnapPlace> snappedPlace(const std::vector<SnapPlace>&, const SnapAim&);

/// "midpoint", "centre", .. for the status line and beside the marker; empty for the ground and for faces.
QString snapPlaceName(SnapPlace::Kind);

}  // namespace blossom::ui
