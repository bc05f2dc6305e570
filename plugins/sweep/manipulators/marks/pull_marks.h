#pragma once
#include <QString>
#include <vector>

#include "manipulators/edit_region.h"
#include "manipulators/marks/pull_ring.h"
#include "manipulators/place_under_mouse.h"
#include "ui/plugin/tool.h"
#include "ui/tools/typed_text.h"

namespace blossom::sweep {

using Props = std::vector<ui::PropPtr>;

/// What the surface pull tool draws: in the control colour what controls, in the warm one what is active. Lines have a seam
/// in the colour of the background, so that they are seen on a surface of any colour.
class PullMarks {
 public:
  PullMarks(const ui::ToolHost& host, const Facing& facing, Props& props) : host_(host), facing_(facing), props_(props) {}

  /// The point under the mouse, its iso-curves and the borders of what an edit there and its copies would touch.
  void place(const Motion&, const PlaceHit&, const PullMode&, const Vec3& towards);
  void isoCurves(const Motion&, const PlaceHit&, const Vec3& towards);
  void copies(const std::vector<Vec3>&);
  /// Places that go along, and those that stay.
  void chosen(const std::vector<Vec3>& moved, const std::vector<Vec3>& pinned);
  void ring(const Vec3& centre, const PullMode&);
  /// The axis of a twist, through the trajectory.
  void axis(const Vec3& centre, const Vec3& axis);
  /// By which an axis is turned; warm while it is under the mouse.
  void ball(const Vec3& at, bool active);
  /// The arc of the arm, with a text beside its end.
  void turn(const TwistArc&, const QString& text);
  /// Of the point that is dragged.
  void way(const Vec3& from, const Vec3& to);
  /// Numbers about a point, on a card above its ring, or where there is none right above it.
  void tell(const Vec3& at, const QString& text, bool aboveRing);
  /// What is typed about a point, and above it what is wrong with that, if anything.
  void entry(const Vec3& at, const ui::TypedText&, const QString& unit, const QString& wrong);
  /// Why a drag changes nothing, or what is wrong with what is typed, on a card above the ring or above the card there.
  void problem(const Vec3& at, const QString& text, bool aboveCard);

 private:
  void lines(const std::vector<std::vector<Vec3>>&, const Color&, double width);
  /// With a seam; `seam` lies behind what is drawn before it, as all that comes later.
  void seamed(const std::vector<std::vector<Vec3>>&, const Color&, double width);
  void surfaceLines(const SurfaceLines&, double width);
  void points(const std::vector<Vec3>&, const Color&, double pixels);
  [[nodiscard]] Color faint(const Color&) const;

  const ui::ToolHost& host_;
  const Facing& facing_;
  Props& props_;
};

/// x(u, v) at the copies of a place, itself left out. @throws Error as symmetricPlaces.
std::vector<Vec3> copiesOf(const Motion&, const MotionPlace&, const EditSymmetry&);

}  // namespace blossom::sweep
