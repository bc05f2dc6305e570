#include "manipulators/surface_pull_tool.h"

#include <vtkProp.h>

#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "kernel/edit/apply_edits.h"
#include "kernel/edit/motion_symmetry.h"

namespace blossom::sweep {

namespace {

constexpr double gripReach = 8;        // pixels
constexpr double shortestRadius = 40;  // pixels, at which the mouse turns what lies on the axis
constexpr double angleStep = 0.1;      // degrees

double distanceFrom(const Ray& ray, const Vec3& p) {
  const Vec3 from = p - ray.origin;
  return (from - std::max(0.0, from.dot(ray.direction)) * ray.direction).norm();
}

MotionPlace placeOf(const MotionEdit& edit) {
  return std::visit([](const auto& each) { return each.at.front(); }, edit);
}

bool sameAxis(const Vec3& a, const Vec3& b) {
  constexpr double rounding = 1e-9;
  return (a.normalized() - b.normalized()).norm() < rounding;
}

}  // namespace

SurfacePullTool::SurfacePullTool(ui::ToolHost& toolHost, FeatureId feature) : HandleTool(toolHost, std::move(feature)) {
  load();
}

SurfacePullTool::~SurfacePullTool() { loading_.cancel(); }

void SurfacePullTool::load() {
  placement_ = editPlacement(host(), feature());
  last_ = placement_ ? lastEdit(host(), *placement_) : std::nullopt;
  const Shape motion = placement_ ? host().result(placement_->source)->evaluated.shape : Shape();
  if (motion.get<Motion>() == wanted_.get<Motion>()) return;
  wanted_ = motion;
  loading_.cancel();
  loading_ = {};
  show(nullptr);
  if (motion.empty()) return;
  thread_.start([this, motion, token = loading_] {
    std::shared_ptr<const LiveSurface> made;
    try {
      made = liveSurface(motion, Progress(token));
    } catch (const std::exception&) {
      return;  // the features made from the motion tell what is wrong with it
    }
    here_.post([this, token, made = std::move(made)] {
      if (!token.cancelled()) show(made);
    });
  });
}

void SurfacePullTool::show(std::shared_ptr<const LiveSurface> surface) {
  surface_ = std::move(surface);
  under_.reset();
  forgetHovered();
  emit changed();
}

bool SurfacePullTool::press(const ui::ToolEvent& event) {
  if (!held()) look(event);
  return HandleTool::press(event);
}

bool SurfacePullTool::move(const ui::ToolEvent& event) {
  if (held()) return HandleTool::move(event);
  look(event);
  const bool taken = HandleTool::move(event);
  if (hovered()) emit changed();  // another place, though the same handle
  return taken;
}

/// A click is for the view, which selects what is there.
bool SurfacePullTool::release(const ui::ToolEvent& event) {
  const bool dragged = dragged_;
  return HandleTool::release(event) && dragged;
}

bool SurfacePullTool::key(const QKeyEvent& event) {
  if (HandleTool::key(event)) return true;
  const bool plain = held() ? !event.modifiers().testFlag(Qt::ControlModifier)
                            : !(event.modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier));
  if (!surface_ || !plain || !(hovered() || held()) || !mode_.key(event.key())) return false;
  if (held()) follow();
  emit changed();
  return true;
}

void SurfacePullTool::look(const ui::ToolEvent& event) {
  towards_ = event.ray.direction;
  under_.reset();
  onLast_ = false;
  // With Ctrl or Alt the mouse is for the view, so that the surface and its parts can still be selected and turned.
  if (!surface_ || event.modifiers & (Qt::ControlModifier | Qt::AltModifier)) return;
  under_ = lastUnder(event);
  onLast_ = under_.has_value();
  if (!onLast_) under_ = anyUnder(event);
  if (!under_) return;
  const double slack = gripReach * event.millimetresPerPixel;
  const bool hidden = !event.pick.feature.empty() && event.pick.part.distance < under_->distance - slack;
  const auto cut = host().section();
  if (hidden || (cut && cut->height(under_->point) > 0)) under_.reset();
}

/// The place of the last edit is kept hold of even beside the surface, as the tip of what was pulled out.
std::optional<PlaceHit> SurfacePullTool::lastUnder(const ui::ToolEvent& event) const {
  if (!last_) return std::nullopt;
  const MotionPlace at = placeOf(last_->edit);
  const Motion& motion = surface_->motion();
  if (at.v < motion.domainV().first || at.v > motion.domainV().second) return std::nullopt;
  PlaceHit hit = placeHit(motion, {insidePeriod(motion, at.u), at.v});
  hit.distance = (hit.point - event.ray.origin).dot(event.ray.direction);
  if (distanceFrom(event.ray, hit.point) > gripReach * event.millimetresPerPixel) return std::nullopt;
  return hit;
}

std::optional<PlaceHit> SurfacePullTool::anyUnder(const ui::ToolEvent& event) const {
  return surface_->finder.find(event.ray);
}

std::optional<std::size_t> SurfacePullTool::handleUnder(const ui::ToolEvent&) const {
  if (!under_) return std::nullopt;
  return onLast_ ? placeOfLast : anyPlace;
}

bool SurfacePullTool::take(std::size_t handle, const ui::ToolEvent& event) {
  lastBase_.reset();
  if (handle == placeOfLast) {
    try {
      lastBase_ = withEditsApplied(*last_->base.get<Motion>());
    } catch (const Error&) {
      onLast_ = false;
    }
  }
  target_ = DragTarget(*under_, event);
  live_ = std::make_unique<LiveEdit>(surface_);
  pressedAt_ = event.at;
  dragged_ = false;
  return true;
}

void SurfacePullTool::drag(const ui::ToolEvent& event) {
  dragged_ = dragged_ || (event.at - pressedAt_).manhattanLength() >= ui::clickReach;
  if (!dragged_) return;
  target_.follow(event);
  follow();
}

void SurfacePullTool::follow() {
  if (live_ && dragged_) live_->show(base(), currentEdit());
}

void SurfacePullTool::place() {
  const double moved = (target_.now() - target_.start()).norm();
  constexpr double rounding = 1e-9;
  if (!dragged_ || moved <= rounding * (1 + target_.start().norm()) || !live_->arrived()) return;
  if (mode_.twists() && angle() == 0) return;
  const MotionEdit edit = currentEdit();
  const QString what = mode_.twists() ? tr("Twist the surface") : tr("Pull the surface");
  commit(changesLast() ? withChangedEdit(host(), last_->id, edit) : withEdit(host(), *placement_, edit), what);
}

void SurfacePullTool::putBack() {
  live_.reset();
  dragged_ = false;
}

/// Grabbed at its place, and pulled in the same way.
bool SurfacePullTool::changesLast() const {
  if (!onLast_ || !last_ || !lastBase_) return false;
  if (const auto* pull = std::get_if<MotionPull>(&last_->edit))
    return !mode_.twists() && pull->weights == mode_.weights() && pull->symmetry == mode_.symmetry();
  const auto& twist = std::get<MotionTwist>(last_->edit);
  return mode_.twists() && twist.symmetry == mode_.symmetry() &&
         sameAxis(twist.axis, twistAxis(surface_->motion(), under_->at, mode_.axis()));
}

const Motion& SurfacePullTool::base() const { return changesLast() ? *lastBase_ : surface_->motion(); }

MotionEdit SurfacePullTool::currentEdit() const {
  if (mode_.twists()) return currentTwist();
  return currentPull();
}

MotionPull SurfacePullTool::currentPull() const {
  MotionPull pull{{under_->at}, {}, mode_.weights()};
  pull.symmetry = mode_.symmetry();
  if (changesLast()) pull = std::get<MotionPull>(last_->edit);
  pull.to = {reachableTarget(base(), under_->at, mode_.way(), target_.now())};
  return pull;
}

MotionTwist SurfacePullTool::currentTwist() const {
  MotionTwist twist{{under_->at}, twistAxis(surface_->motion(), under_->at, mode_.axis()), 0};
  twist.symmetry = mode_.symmetry();
  if (changesLast()) twist = std::get<MotionTwist>(last_->edit);
  constexpr double fullTurn = 360;
  twist.angle = std::clamp(twist.angle + angle(), -fullTurn, fullTurn);
  return twist;
}

/// Of the drag, in steps that can be read.
double SurfacePullTool::angle() const {
  const Vec3 axis = twistAxis(surface_->motion(), under_->at, mode_.axis());
  const Vec3 arm = under_->point - point(surface_->motion().trajectory, under_->at.v);
  const double degrees =
      draggedAngle(axis, arm, target_.now() - target_.start(), target_.towards(), shortestRadius * millimetresPerPixel());
  return angleStep * std::round(degrees / angleStep);
}

}  // namespace blossom::sweep
