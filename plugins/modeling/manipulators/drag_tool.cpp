#include "manipulators/drag_tool.h"

#include <vtkProp.h>

#include <QKeyEvent>

#include "manipulators/tool_paint.h"

namespace blossom::modeling {
DragTool::DragTool(ui::ToolHost& toolHost, FeatureId feature) : Tool(toolHost), feature_(std::move(feature)) {
  // Until the mouse tells better: grid lines are some twenty pixels apart.
  millimetresPerPixel_ = toolHost.gridSpacing() / 20;
  load();
}

void DragTool::load() {
  base_ = host().document();
  const Feature& feature = base_.at(feature_);
  parameters_ = completed(host().registry().at(feature.type)->parameters, feature.parameters);
}

Document DragTool::with(const Value& parameters) const {
  Feature feature = base_.at(feature_);
  feature.parameters = parameters;
  return base_.with(std::move(feature));
}

void DragTool::documentChanged() {
  if (dragging_ || committing_) return;  // the preview itself
  if (!host().document().contains(feature_)) {
    emit finished();
    return;
  }
  load();
  const std::size_t count = points(parameters_).size();
  if (hovered_ && *hovered_ >= count) hovered_.reset();
  if (chosen_ && *chosen_ >= count) chosen_.reset();
  emit changed();
}

void DragTool::commit(const Value& parameters, const QString& what) {
  committing_ = true;  // the host tells of the change before it returns
  parameters_ = parameters;
  host().commit(with(parameters), what);
  committing_ = false;
  documentChanged();
}

std::optional<std::size_t> DragTool::under(const ui::ToolEvent& event) const {
  const auto at = inGround(event.ray);
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
  noteScale(event);
  if (event.button != Qt::LeftButton) return false;
  chosen_ = hovered_ = under(event);
  emit changed();
  if (!chosen_) return false;
  load();
  scene_ = snapScene(host(), feature_);
  before_ = parameters_;
  dragging_ = true;
  return true;
}

void DragTool::drag(const ui::ToolEvent& event) {
  const auto at = inGround(event.ray);
  if (!at) return;
  const Point grabbed = points(before_).at(*chosen_);
  const bool free = event.modifiers.testFlag(Qt::ControlModifier);
  SnapQuery query{*at, reachPixels * event.millimetresPerPixel, host().gridSpacing(), grabbed.anchor, {}, {}};
  snap_ = free ? Snap{*at, SnapKind::None, {}} : snapped(scene_, query);
  const auto next = dragged(before_, *chosen_, snap_->point);
  if (!next || *next == parameters_) return;
  parameters_ = *next;
  host().preview(with(parameters_));
}

bool DragTool::move(const ui::ToolEvent& event) {
  noteScale(event);
  if (dragging_) {
    drag(event);
    emit changed();
    return true;
  }
  const auto found = under(event);
  if (found != hovered_) {
    hovered_ = found;
    emit changed();
  }
  return hovered_.has_value() && event.button == Qt::NoButton;
}

bool DragTool::release(const ui::ToolEvent& event) {
  if (!dragging_ || event.button != Qt::LeftButton) return false;
  const Value made = parameters_;
  const QString what = points(before_).at(*chosen_).what;
  const bool differs = made != before_;
  endDrag();
  if (differs) {
    commit(made, tr("Move %1").arg(what));
  } else {
    emit changed();
  }
  return true;
}

void DragTool::endDrag() {
  dragging_ = false;
  snap_.reset();
  parameters_ = before_;
  host().endPreview();
}

void DragTool::revert() {
  if (dragging_) endDrag();
}

bool DragTool::key(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Escape || !dragging_) return false;
  endDrag();
  emit changed();
  return true;
}

QString DragTool::idleHint() const { return tr("Drag a handle to change the shape"); }

QString DragTool::hint() const {
  if (dragging_) {
    const QString caught = snap_ ? snapName(snap_->kind) : QString();
    return tr("Let go to place %1 · Ctrl: no snapping · Esc takes it back").arg(points(before_).at(*chosen_).what) +
           (caught.isEmpty() ? QString() : QStringLiteral(" · ") + caught);
  }
  if (hovered_) return tr("Drag to move %1").arg(points(parameters_).at(*hovered_).what);
  return idleHint();
}

void DragTool::paint(ToolPaint&, const Value&) const {}

std::vector<vtkSmartPointer<vtkProp>> DragTool::props() const {
  ToolPaint painter(host().look(), millimetresPerPixel_, host().pixelRatio());
  paint(painter, parameters_);
  if (snap_) {
    for (const Guide& guide : snap_->guides) painter.guide(guide, snap_->point);
    painter.snapMarker(snap_->point, snap_->kind);
    if (snap_->kind != SnapKind::None && snap_->kind != SnapKind::Grid)
      painter.label(snap_->point, snapName(snap_->kind), painter.look().control);
  }
  const std::vector<Point> all = points(parameters_);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool lit = k == hovered_ || (k == chosen_);
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
