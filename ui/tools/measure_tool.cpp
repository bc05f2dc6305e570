#include "ui/tools/measure_tool.h"

#include <QKeyEvent>

#include "ui/tools/measure_panel.h"

namespace blossom::ui {

namespace {

std::optional<PartReference> referenceTo(const Pick& pick) {
  if (pick.feature.empty()) return std::nullopt;
  return PartReference{pick.feature, pick.part.kind, pick.part.index};
}

}  // namespace

MeasureTool::MeasureTool(ToolHost& host, Measurements& measurements, QWidget* view)
    : Tool(host), measurements_(measurements), panel_(view ? new MeasurePanel(measurements, view) : nullptr) {
  if (panel_) panel_->show();
}

MeasureTool::~MeasureTool() { delete panel_; }

QString MeasureTool::hint() const {
  const QString part = hovered_ ? measurements_.partName(*hovered_) : QString();
  if (first_)
    return hovered_ && *hovered_ != *first_ ? tr("Click: measure to %1 · Enter: keep as it is").arg(part)
                                            : tr("Click a second part · Enter: keep as it is · Del: delete");
  return hovered_ ? tr("Click: measure %1").arg(part) : tr("Click a face, an edge or a point to measure it · Esc: finish");
}

bool MeasureTool::press(const ToolEvent& event) {
  pressedAt_.reset();
  if (event.button == Qt::LeftButton && event.modifiers == Qt::NoModifier) pressedAt_ = event.at;
  return false;  // a drag from here still turns the camera
}

bool MeasureTool::move(const ToolEvent& event) {
  const auto under = referenceTo(event.pick);
  if (under == hovered_) return false;
  hovered_ = under;
  emit changed();
  return false;
}

bool MeasureTool::release(const ToolEvent& event) {
  const bool clicked = pressedAt_ && (event.at - *pressedAt_).manhattanLength() < clickReach;
  pressedAt_.reset();
  if (!clicked) return false;
  if (const auto part = referenceTo(event.pick))
    take(*part);
  else
    first_.reset();
  emit changed();
  return true;
}

void MeasureTool::take(const PartReference& part) {
  if (first_ && part == *first_) {
    first_.reset();
  } else if (first_ && measurements_.find(open_)) {
    measurements_.extend(open_, part);
    first_.reset();
  } else {
    first_ = part;
    open_ = measurements_.add(part);
  }
}

bool MeasureTool::key(const QKeyEvent& event) {
  switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (!first_) return false;
      first_.reset();
      break;
    case Qt::Key_Escape:
      if (!first_) return false;
      measurements_.remove(open_);
      first_.reset();
      break;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      first_.reset();
      measurements_.remove(measurements_.selected());
      break;
    default:
      if (!event.matches(QKeySequence::Copy) || !panel_) return false;
      panel_->copy();
      return true;
  }
  emit changed();
  return true;
}

}  // namespace blossom::ui
