// What the mouse does in the view.
#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/look/text.h"
#include "ui/look/units.h"
#include "ui/view/view_band.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

namespace {

constexpr double zoomPerPixel = 0.006;

bool isFromTouchpad(const QWheelEvent& event) {
  if (event.pixelDelta().isNull()) return false;
  const auto* device = event.pointingDevice();
  return event.phase() != Qt::NoScrollPhase || (device && device->type() == QInputDevice::DeviceType::TouchPad);
}

}  // namespace

void ViewWidget::setNavigation(NavigationStyle style) { navigation_ = style; }

QString ViewWidget::restingHint() const { return tool_ && !handles_ ? tool_->hint() : idleHint(navigation_); }

void ViewWidget::mousePressEvent(QMouseEvent* event) {
  event->accept();
  toolHasMouse_ = tool_ && tool_->press(toolEvent(event->position(), event->button(), event->modifiers()));
  if (toolHasMouse_) {
    drag_ = DragAction::None;
    pressed_ = false;
    return;
  }
  startDrag(event->position(), event->buttons(), event->modifiers());
}

void ViewWidget::startDrag(QPointF at, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
  pressed_ = true;
  moved_ = false;
  pressedAt_ = lastAt_ = at;
  drag_ = dragAction(navigation_, buttons, modifiers);
  if (drag_ == DragAction::Box && tool_ && !handles_) drag_ = DragAction::None;  // the tool says what is selected
  pivot_.reset();
  if (drag_ != DragAction::Orbit) return;
  if (const Pick under = pickAt(at, PickMode::Feature); !under.feature.empty()) pivot_ = under.part.point;
}

void ViewWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (toolHasMouse_) {
    if (tool_) tool_->move(toolEvent(at, Qt::NoButton, event->modifiers()));
    tellWhereabouts(at);
    return;
  }
  if (!pressed_) {
    hoverAt(at, event->modifiers());
    tellWhereabouts(at);
    return;
  }
  if (!moved_ && (at - pressedAt_).manhattanLength() < clickReach) return;
  moved_ = true;
  drag(at);
}

void ViewWidget::drag(QPointF at) {
  const QPointF by = at - lastAt_;
  lastAt_ = at;
  setHovered({});
  switch (drag_) {
    case DragAction::Orbit:
      setCursor(Qt::SizeAllCursor);
      emit hint(tr("Orbiting"));
      return camera_.orbit(by, pivot_);
    case DragAction::Pan:
      setCursor(Qt::ClosedHandCursor);
      emit hint(tr("Panning"));
      return camera_.pan(by);
    case DragAction::Zoom:
      setCursor(Qt::SizeVerCursor);
      emit hint(tr("Zooming"));
      return camera_.zoom(pressedAt_, std::exp(by.y() * zoomPerPixel));
    case DragAction::Box:
      emit hint(at.x() < pressedAt_.x() ? tr("Selects what the box touches") : tr("Selects what lies wholly in the box"));
      return band_->span(pressedAt_, at);
    case DragAction::None:
      return;
  }
}

void ViewWidget::mouseReleaseEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  const bool taken = tool_ && tool_->release(toolEvent(at, event->button(), event->modifiers()));
  const bool clicked = pressed_ && !moved_ && !toolHasMouse_ && !taken;
  if (event->buttons() == Qt::NoButton) toolHasMouse_ = false;
  const DragAction ended = std::exchange(drag_, DragAction::None);
  const bool wasMoved = std::exchange(moved_, false);
  pressed_ = false;
  unsetCursor();
  emit hint(restingHint());
  if (ended == DragAction::Box && wasMoved) return finishBox(at, event->modifiers());
  if (!clicked) return;
  if (event->button() == Qt::LeftButton) click(at, event->modifiers());
  if (event->button() == Qt::RightButton) emit contextMenuWanted(event->globalPosition().toPoint(), pickAt(at, pickMode_));
}

void ViewWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  const ToolEvent at = toolEvent(event->position(), event->button(), event->modifiers());
  if (tool_ && (tool_->doubleClick(at) || (tool_ && tool_->press(at)))) {
    toolHasMouse_ = true;
    return;
  }
  if (event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton) fit();
}

void ViewWidget::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (isFromTouchpad(*event) && !event->modifiers().testFlag(Qt::ControlModifier)) {
    camera_.pan(event->pixelDelta());
    return;
  }
  const double notches = event->angleDelta().y() / 120.0;
  if (notches != 0) camera_.zoom(event->position(), std::pow(0.86, notches));
  tellWhereabouts(event->position());
}

bool ViewWidget::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture) {
    const auto& gesture = static_cast<const QNativeGestureEvent&>(*event);
    if (gesture.gestureType() == Qt::ZoomNativeGesture) camera_.zoom(gesture.position(), std::exp(-gesture.value()));
    if (gesture.gestureType() == Qt::SmartZoomNativeGesture) fit();
    event->accept();
    return true;
  }
  if (event->type() == QEvent::ShortcutOverride && offerKey(static_cast<const QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

// The right button opens it when it is released without a drag; the key opens it where the mouse is.
void ViewWidget::contextMenuEvent(QContextMenuEvent* event) {
  event->accept();
  if (event->reason() == QContextMenuEvent::Keyboard)
    emit contextMenuWanted(event->globalPos(), pickAt(event->pos(), pickMode_));
}

void ViewWidget::leaveEvent(QEvent*) {
  setHovered({});
  emit hint({});
  emit whereabouts({});
}

void ViewWidget::tellWhereabouts(QPointF at) {
  const Ray ray = camera_.rayThrough(at);
  const QString grid = tr("grid %1").arg(readableLength(grid_.spacing()));
  const double reach = std::abs(ray.direction.z()) > 0.05 ? -ray.origin.z() / ray.direction.z() : -1;
  if (reach <= 0) {
    emit whereabouts(grid);
    return;
  }
  const Vec3 p = ray.origin + ray.direction * reach;
  const LengthUnit& unit = lengthUnit();
  const double perPixel = camera_.millimetresPerPixel() / unit.millimetres;
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(perPixel))), 0, 6);
  const auto shown = [&](double value) { return QString::number(value / unit.millimetres, 'f', decimals); };
  emit whereabouts(tr("x %1   y %2 %3   ·   %4").arg(shown(p.x()), shown(p.y()), qt(unit.name), grid));
}

}  // namespace blossom::ui
