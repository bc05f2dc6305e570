#pragma once
#include <optional>
#include <vector>

#include "manipulators/edit_region.h"
#include "manipulators/live_edit.h"
#include "manipulators/pull_ring.h"
#include "ui/plugin/tool.h"

namespace blossom::sweep {

using Props = std::vector<ui::PropPtr>;

/// What the surface pull tool draws, in the control colour what controls and in the warm one what is being made.
class PullMarks {
 public:
  PullMarks(const ui::ToolHost& host, const Facing& facing, Props& props) : host_(host), facing_(facing), props_(props) {}

  /// The point under the mouse, its iso-curves and the border of what an edit there would touch.
  void place(const Motion&, const PlaceHit&, const PullMode&, const Vec3& towards);
  void copies(const std::vector<Vec3>&);
  void ring(const Vec3& centre, const PullMode&);
  /// The axis through the trajectory, and with an angle the arc that the arm describes.
  void twist(const Vec3& centre, const Vec3& axis, const Vec3& arm, const std::optional<double>& degrees);
  /// The surface as it becomes, and the way of the point that is dragged.
  void drag(const LiveEdit&, const Vec3& from, const Vec3& to);

 private:
  void lines(const std::vector<std::vector<Vec3>>&, const Color&, double width);
  void surfaceLines(const SurfaceLines&, double width);
  [[nodiscard]] Color faint(const Color&) const;

  const ui::ToolHost& host_;
  const Facing& facing_;
  Props& props_;
};

/// x(u, v) at the copies of a place, itself left out. @throws Error as symmetricPlaces.
std::vector<Vec3> copiesOf(const Motion&, const MotionPlace&, const EditSymmetry&);

}  // namespace blossom::sweep
