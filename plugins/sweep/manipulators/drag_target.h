#pragma once
#include "geometry/shape/motion_edit.h"
#include "manipulators/place_under_mouse.h"
#include "manipulators/pull_mode.h"
#include "ui/plugin/tool.h"

namespace blossom::sweep {

/// Where the mouse takes a point of the surface. It begins at the point exactly, wherever in its reach it was taken hold of.
class DragTarget {
 public:
  DragTarget() = default;
  DragTarget(const PlaceHit& start, const ui::ToolEvent&);
  /// Without a mouse: the goal is typed.
  DragTarget(const PlaceHit& start, const Vec3& towards);

  /// In the plane through the point that faces the viewer; with Shift along the normal of the surface, which is followed up
  /// and down the screen where it points at the viewer. Where the mouse determines no point, the one before.
  const Vec3& follow(const ui::ToolEvent&);
  [[nodiscard]] const Vec3& now() const { return now_; }
  [[nodiscard]] const Vec3& start() const { return start_; }
  [[nodiscard]] const Vec3& towards() const { return towards_; }  ///< from the viewer, unit length

 private:
  [[nodiscard]] std::optional<Vec3> inPlane(const Ray&) const;
  void followNormal(const Ray&, const std::optional<Vec3>& held);

  Vec3 start_ = Vec3::Zero(), now_ = Vec3::Zero(), normal_ = Vec3::UnitZ(), towards_ = Vec3::UnitY();
  Vec3 off_ = Vec3::Zero();  ///< from the point to where the mouse took hold
};

/// The axis of a twist at a place, unit length. Where the one chosen has no direction, the z axis.
Vec3 twistAxis(const Motion&, const MotionPlace&, PullMode::Axis);

/// Degrees by which a movement in the plane that faces the viewer turns about an axis of unit length: a point at `arm` from
/// the axis follows the mouse where the axis points to the viewer; where it lies across, the near side of the surface
/// follows. @param shortest radius at which the mouse turns
double draggedAngle(const Vec3& axis, const Vec3& arm, const Vec3& moved, const Vec3& towards, double shortest);

}  // namespace blossom::sweep
