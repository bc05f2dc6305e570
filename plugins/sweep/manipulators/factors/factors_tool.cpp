#include "manipulators/factors/factors_tool.h"

#include <vtkProp.h>

#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "kernel/begin/motion_knots.h"
#include "manipulators/factors/factor_amounts.h"
#include "manipulators/factors/factors_panel.h"
#include "ui/look/screen_distance.h"
#include "ui/look/text.h"

namespace blossom::sweep {

namespace {

constexpr double poleGrip = 9, axisGrip = 6, axisReach = 64;  // on the screen

}  // namespace

FactorsTool::FactorsTool(ui::ToolHost& toolHost, const FeatureId& feature)
    : HandleTool(toolHost, featureOfFactors(toolHost, feature)) {
  makePanel();
  load();
}

FactorsTool::~FactorsTool() { delete panel_; }

void FactorsTool::load() {
  if (lingering_ && lingering_->over(host())) lingering_.reset();
  cancelPanel();
  placement_ = factorPlacement(host(), feature());
  const Shape given = placement_ ? host().result(placement_->source)->evaluated.shape : Shape();
  // While the next one is computed, the one before stays in sight.
  if (!given.empty()) loader_.load(given);
  tellEditable();
}

void FactorsTool::show(std::shared_ptr<const LiveSurface> surface) {
  if (held()) putBack();
  live_.reset();
  surface_ = std::move(surface);
  forgetHovered();
  if (panel_) panel_->net().setPoles(layoutOf(surface_->motion(), factor_));
  fillPanel();
  drawMotion();
  tellEditable();
  emit changed();
}

/// The net stays as it is while the motion is computed: it would only flicker.
void FactorsTool::tellEditable() {
  if (panel_) panel_->net().setProperty("editable", editable());
}

bool FactorsTool::editable() const {
  return surface_ && placement_ && host().document().contains(placement_->source) &&
         surface_->shape.get<Motion>() == loader_.wanted().get<Motion>();
}

std::vector<Vec3> FactorsTool::poles() const {
  std::vector<Vec3> all;
  for (const Vec4& pole : motion().trajectory.poles) all.emplace_back(pole.head<3>() / pole[3]);
  return all;
}

std::optional<Vec3> FactorsTool::axesAt() const {
  if (!surface_ || factor_ != Factor::Trajectory || chosen_.size() != 1) return std::nullopt;
  const std::vector<Vec3> all = poles();
  const std::size_t pole = chosen_.begin()->column;
  return pole < all.size() ? std::optional(all[pole]) : std::nullopt;
}

double FactorsTool::axisLength() const { return axisReach * millimetresPerPixel(); }

bool FactorsTool::press(const ui::ToolEvent& event) {
  towards_ = event.ray.direction;
  return HandleTool::press(event);
}

bool FactorsTool::move(const ui::ToolEvent& event) {
  if (!held()) {
    towards_ = event.ray.direction;
    look();
    said_.clear();
  }
  return HandleTool::move(event);
}

/// A click chooses a pole; it is not for what lies behind.
bool FactorsTool::release(const ui::ToolEvent& event) { return HandleTool::release(event); }

std::optional<std::size_t> FactorsTool::handleUnder(const ui::ToolEvent& event) const {
  if (!editable() || factor_ != Factor::Trajectory || onPanel_) return std::nullopt;
  if (event.modifiers & Qt::AltModifier) return std::nullopt;
  const std::vector<Vec3> all = poles();
  std::optional<std::size_t> nearest;
  double least = poleGrip;
  const auto offer = [&](std::size_t handle, double distance) {
    if (distance < least) least = distance, nearest = handle;
  };
  for (std::size_t k = 0; k < all.size(); ++k)
    if (const auto at = host().onScreen(all[k])) offer(k, std::hypot(at->x() - event.at.x(), at->y() - event.at.y()));
  const auto origin = axesAt();
  if (nearest || !origin) return nearest;
  least = axisGrip;
  for (int k = 0; k < 3; ++k) {
    const auto from = host().onScreen(*origin), to = host().onScreen(*origin + axisLength() * Vec3::Unit(k));
    if (from && to) offer(all.size() + static_cast<std::size_t>(k), ui::distanceToSegment(event.at, *from, *to));
  }
  return nearest;
}

bool FactorsTool::take(std::size_t handle, const ui::ToolEvent& event) {
  const std::vector<Vec3> all = poles();
  std::optional<Vec3> axis;
  if (handle < all.size()) {
    const FactorPole pole{0, handle};
    const bool more = event.modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
    if (more && chosen_.contains(pole)) {
      chosen_.erase(pole);
    } else {
      if (!more && !chosen_.contains(pole)) chosen_.clear();
      chosen_.insert(pole);
    }
    if (panel_) panel_->net().choose(chosen_);
    fillPanel();
    if (!chosen_.contains(pole)) return false;
  } else {
    axis = Vec3::Unit(static_cast<Eigen::Index>(handle - all.size()));
  }
  const Vec3 start = handle < all.size() ? all[handle] : *axesAt();
  pole_ = PoleDrag(start, axis, event.ray);
  startLive();
  pressedAt_ = event.at;
  dragged_ = false;
  return true;
}

void FactorsTool::drag(const ui::ToolEvent& event) {
  dragged_ = dragged_ || (event.at - pressedAt_).manhattanLength() >= ui::clickReach;
  if (!dragged_ || !live_) return;
  pole_.follow(event.ray);
  follow(movedPoles(chosen_, pole_.moved()));
}

void FactorsTool::follow(const FactorChanges& changes) {
  live_->show(changes);
  fillPanel();
  drawMotion();
}

void FactorsTool::place() {
  if (!dragged_ || !live_ || !live_->possible() || !editable()) return;
  if (live_->changes().empty() || pole_.moved().norm() == 0) return;
  commitDrag(tr("Move poles of the trajectory"));
}

void FactorsTool::startLive() {
  live_ = std::make_unique<FactorLive>(surface_, placement_ && makesSolid(host(), *placement_));
}

/// The changes that are seen as one step of undo; what is seen stays until the sweep is computed.
void FactorsTool::commitDrag(const QString& what) {
  const std::unique_ptr<FactorLive> done = std::move(live_);
  std::optional<LingeringPicture> lingering;
  lingering.emplace(host(), done->mesh().standIn(placement_->users));
  commit(withFactorChanges(host(), *placement_, done->changes()), what);
  lingering->begin(host());
  if (!lingering->over(host())) lingering_ = std::move(lingering);
}

void FactorsTool::putBack() {
  live_.reset();
  dragged_ = false;
  fillPanel();
  drawMotion();
}

void FactorsTool::revert() {
  cancelPanel();
  HandleTool::revert();
}

bool FactorsTool::key(const QKeyEvent& event) {
  if (event.key() == Qt::Key_Escape && onPanel_) {
    cancelPanel();
    return true;
  }
  return HandleTool::key(event);
}

/// The changes as one step of undo; what the kernel refuses is said at the field.
void FactorsTool::enter(const FactorChanges& changes, const QString& what, int field) {
  if (!editable() || changes.empty()) return;
  try {
    if (withChangedFactors(surface_->motion(), changes).changedPoles == 0) return;
    commit(withFactorChanges(host(), *placement_, changes), what);
  } catch (const Error& error) {
    if (panel_) panel_->refuse(field, ui::saidInFull(error));
    fillPanel();
  }
}

void FactorsTool::insertKnot(bool alongU, double knot) {
  if (!editable()) return;
  try {
    MotionKnots knots{{}, {}, factor_ == Factor::Trajectory, factor_ == Factor::Orientation, factor_ == Factor::Scaling};
    (alongU ? knots.u : knots.v) = {knot};
    static_cast<void>(withKnots(surface_->motion(), knots));  // says what would be wrong
    commit(withFactorKnot(host(), *placement_, factor_, alongU, knot), tr("Insert a knot"));
  } catch (const Error& error) {
    if (panel_) panel_->refuse(-1, ui::saidInFull(error));
  }
}

}  // namespace blossom::sweep
