#include "manipulators/held_edit.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "kernel/edit/apply_edits.h"
#include "manipulators/reachable_target.h"

namespace blossom::sweep {

namespace {

constexpr double shortestRadius = 40;  // pixels, at which the mouse turns what lies on the axis
constexpr double angleStep = 0.1;      // degrees
constexpr double fullTurn = 360;

bool sameAxis(const Vec3& a, const Vec3& b) {
  constexpr double asRead = 1e-3;  // axes are kept with three decimals
  return (a.normalized() - b.normalized()).norm() < asRead;
}

}  // namespace

HeldEdit::HeldEdit(Start start) : start_(std::move(start)), live_(start_.surface, start_.capped) {
  if (!start_.grip.of || !start_.changed) return;
  try {
    base_ = withEditsApplied(*start_.changed->base.get<Motion>());
  } catch (const Error&) {
    if (start_.ball || start_.changed->isFollowed) throw;
    start_.grip.of.reset();  // then one more edit is made
  }
}

void HeldEdit::follow(const ui::ToolEvent& event) {
  start_.pixel = event.millimetresPerPixel;
  start_.target.follow(event);
  if (start_.ball) followAxis(event);
}

/// With Shift, to an axis that has a name.
void HeldEdit::followAxis(const ui::ToolEvent& event) {
  const Vec3 axis = axisUnder(*start_.ball, event.ray);
  const bool named = event.modifiers.testFlag(Qt::ShiftModifier);
  axis_ = named ? nearestNamedAxis(axis, *base_, start_.grip.hit.at) : readableAxis(axis);
}

void HeldEdit::show(const PullMode& mode) { live_.show(base(mode), edit(mode)); }

bool HeldEdit::changesOne(const PullMode& mode) const {
  if (!start_.grip.of || !start_.changed || !base_) return false;
  if (start_.changed->isFollowed || start_.ball) return true;
  if (!start_.chosen.empty()) return false;
  if (const auto* pull = std::get_if<MotionPull>(&start_.changed->edit))
    return !mode.twists() && pull->weights == mode.weights() && pull->symmetry == mode.symmetry() &&
           pull->level == mode.level();
  const auto& twist = std::get<MotionTwist>(start_.changed->edit);
  return mode.twists() && twist.symmetry == mode.symmetry() && twist.level == mode.level() &&
         sameAxis(twist.axis, twistAxis(*base_, start_.grip.hit.at, mode.axis()));
}

bool HeldEdit::twists(const PullMode& mode) const {
  return changesOne(mode) ? std::holds_alternative<MotionTwist>(start_.changed->edit) : mode.twists();
}

Vec3 HeldEdit::axis(const PullMode& mode) const {
  if (axis_) return axis_->normalized();
  return changesOne(mode) ? Vec3(std::get<MotionTwist>(start_.changed->edit).axis.normalized())
                          : twistAxis(before(), start_.grip.hit.at, mode.axis());
}

const Motion& HeldEdit::base(const PullMode& mode) const { return changesOne(mode) ? *base_ : before(); }

MotionEdit HeldEdit::edit(const PullMode& mode) const {
  if (twists(mode)) return twist(mode);
  return pull(mode);
}

/// Of a new edit: what is held first, then what goes along.
std::vector<MotionPlace> HeldEdit::places() const {
  std::vector<MotionPlace> all{start_.grip.hit.at};
  for (const MotionPlace& at : start_.chosen.moved)
    if (!(at == all.front())) all.push_back(at);
  return all;
}

std::size_t HeldEdit::place() const { return start_.grip.of ? start_.grip.of->place : 0; }

std::size_t HeldEdit::countOfPlaces(const PullMode& mode) const {
  return changesOne(mode) ? editedPlaces(start_.changed->edit).size() : places().size();
}

std::size_t HeldEdit::countOfPins(const PullMode& mode) const {
  if (!changesOne(mode)) return start_.chosen.pinned.size();
  return std::visit([](const auto& each) { return each.pins.size(); }, start_.changed->edit);
}

/// What goes along goes the same way as what is held. A goal that was typed is meant exactly.
MotionPull HeldEdit::pull(const PullMode& mode) const {
  const bool changes = changesOne(mode);
  const Vec3 way = goal() - from();
  MotionPull pull{places(), {}, mode.weights()};
  pull.pins = start_.chosen.pinned;
  pull.symmetry = mode.symmetry();
  pull.level = mode.level();
  if (changes) pull = std::get<MotionPull>(start_.changed->edit);
  pull.to.clear();
  const std::size_t held = changes ? place() : 0;
  for (std::size_t k = 0; k < pull.at.size(); ++k) {
    const Vec3 aim = k == held ? goal() : Vec3(placeHit(before(), pull.at[k]).point + way);
    pull.to.push_back(goal_ ? aim : reachableTarget(base(mode), pull.at[k], pull.weights, aim));
  }
  return pull;
}

MotionTwist HeldEdit::twist(const PullMode& mode) const {
  MotionTwist twist{places(), twistAxis(before(), start_.grip.hit.at, mode.axis()), 0, start_.chosen.pinned,
                    mode.symmetry()};
  twist.level = mode.level();
  if (changesOne(mode)) twist = std::get<MotionTwist>(start_.changed->edit);
  if (axis_) twist.axis = *axis_;
  if (!turned_ && start_.ball) return twist;
  twist.angle = turned_.value_or(std::clamp(twist.angle + mouseAngle(mode), -fullTurn, fullTurn));
  return twist;
}

double HeldEdit::angle(const PullMode& mode) const { return twist(mode).angle; }

double HeldEdit::turnedBy(const PullMode& mode) const {
  const double already = changesOne(mode) ? std::get<MotionTwist>(start_.changed->edit).angle : 0;
  return angle(mode) - already;
}

double HeldEdit::mouseAngle(const PullMode& mode) const {
  const PlaceHit& held = start_.grip.hit;
  const Vec3 axis = this->axis(mode), arm = held.point - point(before().trajectory, held.at.v);
  const double degrees =
      draggedAngle(axis, arm, start_.target.now() - from(), start_.target.towards(), shortestRadius * start_.pixel);
  return angleStep * std::round(degrees / angleStep);
}

bool HeldEdit::changesAnything(const PullMode& mode) const {
  if (axis_ && *axis_ != std::get<MotionTwist>(start_.changed->edit).axis) return true;
  if (twists(mode)) return turnedBy(mode) != 0;
  constexpr double rounding = 1e-9;
  return (goal() - from()).norm() > rounding * (1 + from().norm());
}

}  // namespace blossom::sweep
