#pragma once
#include <optional>

#include "manipulators/drag_target.h"
#include "manipulators/live_edit.h"
#include "manipulators/marks/axis_ball.h"
#include "manipulators/marks/pull_grip.h"

namespace blossom::sweep {

/// An edit while it is made: the place that is held, where it goes, what goes along, and the surface that follows. What it
/// does is asked of a PullMode, which may change at any time.
class HeldEdit {
 public:
  struct Start {
    std::shared_ptr<const LiveSurface> surface;  ///< of the edit that is changed, or the last one
    PullGrip grip;
    ChosenPlaces chosen;
    std::optional<ChangeableEdit> changed;  ///< whose place it is
    DragTarget target;
    double pixel = 1;                ///< mm
    bool capped = false;             ///< the ends are drawn closed
    std::optional<AxisBall> ball{};  ///< of a twist that is changed: its axis is turned, and nothing else
  };
  /// @throws Error when the motion before an edit that is changed for certain cannot be made
  explicit HeldEdit(Start);

  void follow(const ui::ToolEvent&);
  void aimAt(const Vec3& goal) { goal_ = goal; }          ///< exactly, whatever the mouse does
  void turnTo(double degrees) { turned_ = degrees; }      ///< of a twist, the same
  void forgetTyped() { goal_.reset(), turned_.reset(); }  ///< the mouse decides again
  void show(const PullMode&);                             ///< brings the surface up to date

  /// Grabbed at a place of an edit, and in the same way, or at its axis; one that others follow is changed in its own way
  /// always.
  [[nodiscard]] bool changesOne(const PullMode&) const;
  [[nodiscard]] bool changesFollowed() const { return start_.grip.of && start_.changed && start_.changed->isFollowed; }
  [[nodiscard]] bool turnsAxis() const { return start_.ball.has_value(); }
  [[nodiscard]] bool twists(const PullMode&) const;
  [[nodiscard]] Vec3 axis(const PullMode&) const;  ///< of the twist, unit length
  [[nodiscard]] MotionEdit edit(const PullMode&) const;
  [[nodiscard]] std::size_t place() const;  ///< which of the edit's places is held
  [[nodiscard]] std::size_t countOfPlaces(const PullMode&) const;
  [[nodiscard]] std::size_t countOfPins(const PullMode&) const;
  [[nodiscard]] double angle(const PullMode&) const;     ///< of the twist, degrees, in steps that can be read
  [[nodiscard]] double turnedBy(const PullMode&) const;  ///< by how much of it the surface has turned since
  [[nodiscard]] bool changesAnything(const PullMode&) const;
  /// It arrives, or as near as all of its places can together.
  [[nodiscard]] bool possible() const { return live_.arrived() || live_.nearest(); }

  [[nodiscard]] const ChangeableEdit& changed() const { return *start_.changed; }  ///< @pre changesOne
  [[nodiscard]] const PullGrip& grip() const { return start_.grip; }
  [[nodiscard]] const ChosenPlaces& chosen() const { return start_.chosen; }
  [[nodiscard]] const Vec3& from() const { return start_.grip.hit.point; }
  [[nodiscard]] const Vec3& goal() const { return goal_ ? *goal_ : start_.target.now(); }
  [[nodiscard]] const LiveEdit& live() const { return live_; }
  [[nodiscard]] const Motion& before() const { return start_.surface->motion(); }  ///< as the surface was when taken

 private:
  [[nodiscard]] const Motion& base(const PullMode&) const;
  [[nodiscard]] MotionPull pull(const PullMode&) const;
  [[nodiscard]] MotionTwist twist(const PullMode&) const;
  [[nodiscard]] std::vector<MotionPlace> places() const;
  [[nodiscard]] double mouseAngle(const PullMode&) const;
  void followAxis(const ui::ToolEvent&);

  Start start_;
  std::optional<Motion> base_;    ///< before the edit that is changed
  std::optional<Vec3> goal_;      ///< that was typed
  std::optional<double> turned_;  ///< likewise the angle
  std::optional<Vec3> axis_;      ///< that the ball was dragged to
  LiveEdit live_;
};

}  // namespace blossom::sweep
