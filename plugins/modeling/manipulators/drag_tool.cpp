#include "manipulators/drag_tool.h"

#include <vtkProp.h>

#include <utility>

#include "manipulators/tool_paint.h"
#include "parameter/written.h"
#include "ui/tools/view_props.h"

namespace blossom::modeling {

DragTool::DragTool(ui::ToolHost& toolHost, FeatureId feature) : HandleTool(toolHost, std::move(feature)) { load(); }

void DragTool::load() {
  base_ = host().document();
  const Feature& now = base_.at(feature());
  const Value before = std::exchange(parameters_, completed(host().registry().at(now.type)->parameters, now.parameters));
  const auto isGone = [this](std::optional<std::size_t> point) { return point && *point >= points(parameters_).size(); };
  if (isGone(hovered())) forgetHovered();
  if (isGone(chosen_)) chosen_.reset();
  if (parameters_ == before) return;  // a result has come: what is being typed stays
  stopTyping();
  pointed_.reset();
}

Document DragTool::with(const Value& parameters) const {
  Feature changed = base_.at(feature());
  changed.parameters = keepWritten(host().registry().at(changed.type)->parameters, changed.parameters, parameters);
  return base_.with(std::move(changed));
}

std::optional<std::size_t> DragTool::handleUnder(const ui::ToolEvent& event) const {
  const auto at = ui::inGround(event.ray);
  if (!at) return std::nullopt;
  std::optional<std::size_t> best;
  double distance = gripPixels * event.millimetresPerPixel;
  const std::vector<Point> all = points(parameters_);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if ((all[k].at - *at).norm() > distance) continue;
    distance = (all[k].at - *at).norm();
    best = k;
  }
  return best;
}

bool DragTool::press(const ui::ToolEvent& event) {
  if (event.button == Qt::LeftButton && typing_ && dimensionUnder(event) != typing_) {
    stopTyping();
    emit changed();
  }
  if (event.button == Qt::LeftButton && chosen_ != handleUnder(event)) {
    chosen_ = handleUnder(event);
    emit changed();
  }
  return HandleTool::press(event) || (event.button == Qt::LeftButton && dimensionUnder(event));
}

// A click on a number is for the number.
bool DragTool::release(const ui::ToolEvent& event) {
  return HandleTool::release(event) || (event.button == Qt::LeftButton && dimensionUnder(event));
}

bool DragTool::move(const ui::ToolEvent& event) {
  const bool taken = HandleTool::move(event);
  const auto under = held() || hovered() ? std::nullopt : dimensionUnder(event);
  if (under != pointed_) {
    pointed_ = under;
    emit changed();
  }
  return taken || (pointed_ && event.button == Qt::NoButton);
}

bool DragTool::key(const QKeyEvent& event) { return typing_ ? typingKey(event) : HandleTool::key(event); }

bool DragTool::take(std::size_t handle, const ui::ToolEvent& /*event*/) {
  load();
  scene_ = snapScene(host(), feature());
  before_ = parameters_;
  return handle < points(parameters_).size();
}

void DragTool::drag(const ui::ToolEvent& event) {
  const auto at = ui::inGround(event.ray);
  if (!at) return;
  const Point grabbed = points(before_).at(*held());
  const bool free = event.modifiers.testFlag(Qt::ControlModifier);
  SnapQuery query{*at, reachPixels * event.millimetresPerPixel, host().gridSpacing(), grabbed.anchor, {}, {}};
  snap_ = free ? Snap{*at, SnapKind::None, {}} : snappedPoint(scene_, query);
  const auto next = dragged(before_, *held(), snap_->point);
  if (!next || *next == parameters_) return;
  parameters_ = *next;
  preview(with(parameters_));
}

void DragTool::place() {
  if (parameters_ != before_) commit(parameters_, tr("Move %1").arg(points(before_).at(*held()).what));
}

void DragTool::putBack() {
  snap_.reset();
  parameters_ = before_;
}

QString DragTool::idleHint() const { return tr("Drag a handle to change the shape"); }

QString DragTool::hint() const {
  if (!refusal_.isEmpty()) return refusal_;
  if (typing_) return tr("Type the size · Enter takes it · Esc leaves it as it is");
  if (pointed_) return tr("Double-click to type %1").arg(dimensions(parameters_).at(*pointed_).what);
  if (held()) {
    const QString caught = snap_ ? snapName(snap_->kind) : QString();
    return tr("Let go to place %1 · Ctrl: no snapping · Esc takes it back").arg(points(before_).at(*held()).what) +
           (caught.isEmpty() ? QString() : QStringLiteral(" · ") + caught);
  }
  if (hovered()) return tr("Drag to move %1").arg(points(parameters_).at(*hovered()).what);
  return idleHint();
}

void DragTool::paint(ToolPaint&, const Value&) const {}

std::vector<vtkSmartPointer<vtkProp>> DragTool::props() const {
  ToolPaint painter(host().look(), millimetresPerPixel(), host().pixelRatio());
  paint(painter, parameters_);
  if (snap_) {
    for (const Guide& guide : snap_->guides) painter.guide(guide, snap_->point);
    painter.snapMarker(snap_->point, snap_->kind);
    if (snap_->kind != SnapKind::None && snap_->kind != SnapKind::Grid)
      painter.label(snap_->point, snapName(snap_->kind), painter.look().control);
  }
  paintDimensions(painter);
  const std::vector<Point> all = points(parameters_);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool lit = k == hovered() || k == chosen_;
    const Color& color = lit ? painter.look().made : painter.look().control;
    if (all[k].round) {
      painter.ring(all[k].at, color, lit ? 6 : 4.5);
    } else {
      painter.square(all[k].at, color, lit, lit ? 4.5 : 3.5);
    }
  }
  return painter.take();
}

}  // namespace blossom::modeling
