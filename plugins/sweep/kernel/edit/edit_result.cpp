#include "kernel/edit/edit_result.h"

#include <fmt/format.h>

namespace blossom::sweep {

namespace {

Explanation reasonOf(Unreached why) {
  switch (why) {
    case Unreached::FrameAxis:
      return {
          "scaling would have to move the point along an axis of the moving frame along which it has no component, so "
          "that no factor does it",
          "Give rotate the share 1, or move the target into the plane or onto the line that scaling can reach."};
    case Unreached::Radius:
      return {"rotation alone keeps the distance from the trajectory", "Give scale a share, too."};
    case Unreached::OnTrajectory:
      return {"the point lies on the trajectory, about which it cannot rotate", "Give translate or scale a share."};
    case Unreached::TargetOnTrajectory:
      return {"the target lies on the trajectory, so that there is no direction to rotate to",
              "Give translate or scale a share."};
    case Unreached::Opposite:
      return {"the target lies on the other side of the trajectory, and half a turn has no axis of its own",
              "Give an axis for it, or pull in two steps."};
    case Unreached::AxisAlongArm:
      return {
          "the target lies on the other side of the trajectory, and the axis given for half a turn points along the line "
          "from the trajectory to the point, which no turn about it moves",
          "Give an axis across that line."};
    case Unreached::Cancelled:
      return {
          "the basis functions around this closed motion cancel each other there, so that no change of its poles "
          "reaches the place",
          "Give the motion more poles in u, or in v when it closes there, or edit at another level."};
    case Unreached::TooClose:
      return {"the places ask for more than the poles they share can do",
              "Pull fewer places, places farther apart, or at a finer level."};
    case Unreached::Pinned:
      return {"the pins hold poles that would have to move",
              "Take a pin away, set it farther from the place, or edit at a finer level."};
    case Unreached::Symmetry:
      return {"the copies of the place ask for more than the poles they share can do",
              "Move the place away from the mirror or from its copies, or choose a target that is its own mirror image; the "
              "trajectory is shared by all copies."};
    case Unreached::TwoTargets:
      return {"two places of this edit are one, and each has a target of its own", "Take one of them away."};
  }
  return {};
}

}  // namespace

Explanation explain(const Obstacle& obstacle) {
  Explanation reason = reasonOf(obstacle.why);
  reason.what = fmt::format("At u = {:.4g}, v = {:.4g}, {}.", obstacle.at.u, obstacle.at.v, reason.what);
  return reason;
}

Explanation explainSwing(double swing) {
  return {
      fmt::format("Poles of the motion move up to {:.0f} times as far as any place of this edit asks, for its places and "
                  "pins nearly share their poles: between them the surface goes far astray.",
                  swing),
      "Set them farther apart in u and v, take a pin away, or edit at a finer level."};
}

}  // namespace blossom::sweep
