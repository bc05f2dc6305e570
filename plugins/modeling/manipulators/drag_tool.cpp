#include "manipulators/drag_tool.h"

#include <vtkProp.h>

#include <QKeyEvent>
#include <QSizeF>
#include <cmath>

#include "core/error.h"
#include "manipulators/tool_paint.h"
#include "parameter/written.h"
#include "ui/tools/view_props.h"

namespace blossom::modeling {
namespace {

constexpr QSizeF halfCard(34, 11);  // logical pixels, of a number on its card

}  // namespace

DragTool::DragTool(ui::ToolHost& toolHost, FeatureId feature) : HandleTool(toolHost, std::move(feature)) { load(); }

void DragTool::load() {
  base_ = host().document();
  const Feature& now = base_.at(feature());
  parameters_ = completed(host().registry().at(now.type)->parameters, now.parameters);
  const auto isGone = [this](std::optional<std::size_t> point) { return point && *point >= points(parameters_).size(); };
  if (isGone(hovered())) forgetHovered();
  if (isGone(chosen_)) chosen_.reset();
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

bool DragTool::move(const ui::ToolEvent& event) {
  const bool taken = HandleTool::move(event);
  const auto under = held() || hovered() ? std::nullopt : dimensionUnder(event);
  if (under != pointed_) {
    pointed_ = under;
    emit changed();
  }
  return taken || (pointed_ && event.button == Qt::NoButton);
}

// A number stands beside the shape, whatever the zoom: above, below, or half a card to the left or right of its place.
QPointF DragTool::shiftOf(const Dimension& dimension) {
  return {halfCard.width() * dimension.beside.x(), (halfCard.height() + ui::labelGap) * (dimension.beside.y() - 1)};
}

std::optional<std::size_t> DragTool::dimensionUnder(const ui::ToolEvent& event) const {
  if (handleUnder(event)) return std::nullopt;
  const std::vector<Dimension> all = dimensions(parameters_);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto seen = host().onScreen({all[k].at.x(), all[k].at.y(), 0});
    if (!seen) continue;
    const QPointF middle = shiftOf(all[k]) + QPointF(0, ui::labelGap + halfCard.height());
    const double right = event.at.x() - seen->x() - middle.x(), up = seen->y() - event.at.y() - middle.y();
    if (std::abs(right) <= halfCard.width() && std::abs(up) <= halfCard.height()) return k;
  }
  return std::nullopt;
}

bool DragTool::doubleClick(const ui::ToolEvent& event) {
  noteScale(event);
  const auto under = event.button == Qt::LeftButton ? dimensionUnder(event) : std::nullopt;
  if (!under) return false;
  typing_ = under;
  typed_.clear();
  refusal_.clear();
  emit changed();
  return true;
}

void DragTool::stopTyping() {
  typing_.reset();
  typed_.clear();
  refusal_.clear();
}

bool DragTool::key(const QKeyEvent& event) {
  if (!typing_) return HandleTool::key(event);
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
  return typingKey(event);
}

bool DragTool::typingKey(const QKeyEvent& event) {
  refusal_.clear();
  switch (event.key()) {
    case Qt::Key_Escape:
      stopTyping();
      break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      takeTyped();
      break;
    case Qt::Key_Backspace:
      typed_.chop(1);
      break;
    default:
      if (event.text().isEmpty() || !event.text().front().isPrint()) return false;
      typed_ += event.text();
  }
  emit changed();
  return true;
}

// What was typed is kept as such where it is a parameter of its own; elsewhere its value goes into the points.
void DragTool::takeTyped() {
  if (typed_.trimmed().isEmpty()) return stopTyping();
  const Dimension dimension = dimensions(parameters_).at(*typing_);
  const FeatureType& type = *host().registry().at(host().document().at(feature()).type);
  try {
    const ParameterSpec* spec = nullptr;
    for (const ParameterSpec& each : type.parameters)
      if (each.name == dimension.parameter) spec = &each;
    ParameterSpec size = positiveLength();
    size.name = "length";
    if (!spec) spec = &size;
    const Value written = host().typed(*spec, typed_);
    const auto next = resized(parameters_, *typing_, checked(*spec, written).get<double>());
    if (!next) {
      refusal_ = tr("The outline cannot have this size.");
      return;
    }
    Feature changed = with(*next).at(feature());
    if (!dimension.parameter.empty()) changed.parameters[dimension.parameter] = written;
    const Document document = base_.with(std::move(changed));
    stopTyping();
    HandleTool::commit(document, tr("Change %1").arg(dimension.what));
  } catch (const Error& error) {
    refusal_ = QString::fromStdString(error.message());
  }
}

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

/// Where a dimension stands; by the last event where there is no view.
double DragTool::pixelsPerMm(const Dimension& dimension) const {
  const Vec2 next = dimension.at + dimension.beside;
  const auto here = host().onScreen({dimension.at.x(), dimension.at.y(), 0});
  const auto there = host().onScreen({next.x(), next.y(), 0});
  if (!here || !there) return 1 / millimetresPerPixel();
  return std::hypot(there->x() - here->x(), there->y() - here->y());
}

void DragTool::paintDimensions(ToolPaint& painter) const {
  constexpr std::size_t mostNumbers = 12;  // more would cover the shape
  constexpr double leastPixels = 36;       // of a side with a number
  const std::vector<Dimension> all = dimensions(parameters_);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool lit = k == pointed_ || k == typing_;
    if (!lit && (all.size() > mostNumbers || all[k].value * pixelsPerMm(all[k]) < leastPixels)) continue;
    const LengthUnit unit = host().lengthUnit();
    const QString shown = QStringLiteral("%1%2 %3").arg(all[k].radius ? QStringLiteral("R ") : QString(),
                                                        QString::number(all[k].value / unit.millimetres, 'g', 6),
                                                        QString::fromStdString(unit.name));
    painter.label(all[k].at, k == typing_ ? typed_ + QStringLiteral(" |") : shown,
                  lit ? painter.look().made : painter.look().control, shiftOf(all[k]));
  }
}

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
