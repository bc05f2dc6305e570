// What the mouse does in the view.
#include <vtkActor.h>
#include <vtkCellPicker.h>
#include <vtkRenderer.h>

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "ui/text.h"
#include "ui/view_widget.h"

namespace blossom::ui {

namespace {

constexpr double clickReach = 4;  // pixels a click may wander

}  // namespace

QString ViewWidget::idleHint() {
  return tr("Click: select · Drag: orbit · Shift+drag or right drag: pan · Wheel: zoom · Double click: fit");
}

void ViewWidget::mousePressEvent(QMouseEvent* event) {
  pressedAt_ = lastAt_ = event->position();
  moved_ = false;
  const bool pan = event->button() == Qt::RightButton || event->modifiers().testFlag(Qt::ShiftModifier);
  drag_ = pan ? Drag::Pan : Drag::Orbit;
  event->accept();
}

void ViewWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (drag_ == Drag::None) {
    emit hint(idleHint());
    tellWhereabouts(at);
    return;
  }
  if (!moved_ && (at - pressedAt_).manhattanLength() < clickReach) return;
  moved_ = true;
  setCursor(drag_ == Drag::Pan ? Qt::ClosedHandCursor : Qt::SizeAllCursor);
  emit hint(drag_ == Drag::Pan ? tr("Panning") : tr("Orbiting"));
  const QPointF by = at - lastAt_;
  lastAt_ = at;
  if (drag_ == Drag::Pan)
    camera_.pan(by);
  else
    camera_.orbit(by);
}

void ViewWidget::mouseReleaseEvent(QMouseEvent* event) {
  const bool clicked = drag_ != Drag::None && !moved_ && event->button() == Qt::LeftButton;
  drag_ = Drag::None;
  unsetCursor();
  emit hint(idleHint());
  if (clicked) emit picked(qt(featureAt(event->position())), event->modifiers().testFlag(Qt::ControlModifier));
}

void ViewWidget::mouseDoubleClickEvent(QMouseEvent*) { fit(); }

void ViewWidget::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (notches != 0) camera_.zoom(event->position(), std::pow(0.86, notches));
  tellWhereabouts(event->position());
  event->accept();
}

void ViewWidget::leaveEvent(QEvent*) {
  emit hint({});
  emit whereabouts({});
}

// Through the cells themselves, so that no picture of ids has to be drawn; one click costs one walk over the triangles.
FeatureId ViewWidget::featureAt(QPointF at) const {
  auto picker = vtkSmartPointer<vtkCellPicker>::New();
  picker->SetTolerance(0.004);
  if (!picker->Pick(at.x() * scale_, (height() - at.y()) * scale_, 0, renderer_)) return {};
  for (const auto& [id, shown] : shown_)
    for (const auto& actor : shown.actors)
      if (actor == picker->GetActor()) return id;
  return {};
}

void ViewWidget::tellWhereabouts(QPointF at) {
  const auto ray = camera_.rayThrough(at);
  const QString grid = tr("grid %1 mm").arg(readable(grid_.spacing()));
  const double reach = std::abs(ray.direction.z()) > 0.05 ? -ray.origin.z() / ray.direction.z() : -1;
  if (reach <= 0) {
    emit whereabouts(grid);
    return;
  }
  const Vec3 p = ray.origin + ray.direction * reach;
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(camera_.millimetresPerPixel()))), 0, 6);
  emit whereabouts(tr("x %1   y %2 mm   ·   %3").arg(p.x(), 0, 'f', decimals).arg(p.y(), 0, 'f', decimals).arg(grid));
}

}  // namespace blossom::ui
