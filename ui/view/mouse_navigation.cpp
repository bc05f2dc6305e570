#include "ui/view/mouse_navigation.h"

#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QWheelEvent>
#include <QWidget>
#include <cmath>
#include <utility>

#include "ui/plugin/tool.h"
#include "ui/view/camera_control.h"
#include "ui/view/view_band.h"

namespace blossom::ui {

namespace {

constexpr double zoomPerPixel = 0.006;

bool isFromTouchpad(const QWheelEvent& event) {
  if (event.pixelDelta().isNull()) return false;
  const auto* device = event.pointingDevice();
  return event.phase() != Qt::NoScrollPhase || (device && device->type() == QInputDevice::DeviceType::TouchPad);
}

}  // namespace

MouseNavigation::MouseNavigation(CameraControl& camera, QWidget& view)
    : QObject(&view), camera_(camera), view_(view), band_(new SelectionBand(&view)) {}

void MouseNavigation::press(QPointF at, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers, bool boxes,
                            const std::function<std::optional<Vec3>()>& pivot) {
  pressed_ = true;
  moved_ = false;
  pressedAt_ = lastAt_ = at;
  action_ = dragAction(style_, buttons, modifiers);
  if (action_ == DragAction::Box && !boxes) action_ = DragAction::None;
  pivot_ = action_ == DragAction::Orbit ? pivot() : std::nullopt;
}

void MouseNavigation::giveUp() {
  action_ = DragAction::None;
  pressed_ = false;
}

bool MouseNavigation::move(QPointF at) {
  if (!moved_ && (at - pressedAt_).manhattanLength() < clickReach) return false;
  moved_ = true;
  drag(at);
  return true;
}

void MouseNavigation::drag(QPointF at) {
  const QPointF by = at - lastAt_;
  lastAt_ = at;
  switch (action_) {
    case DragAction::Orbit:
      view_.setCursor(Qt::SizeAllCursor);
      emit hint(tr("Orbiting"));
      return camera_.orbit(by, pivot_);
    case DragAction::Pan:
      view_.setCursor(Qt::ClosedHandCursor);
      emit hint(tr("Panning"));
      return camera_.pan(by);
    case DragAction::Zoom:
      view_.setCursor(Qt::SizeVerCursor);
      emit hint(tr("Zooming"));
      return camera_.zoom(pressedAt_, std::exp(by.y() * zoomPerPixel));
    case DragAction::Box:
      emit hint(crossing(at) ? tr("Selects what the box touches") : tr("Selects what lies wholly in the box"));
      return band_->span(pressedAt_, at);
    case DragAction::None:
      return;
  }
}

MouseNavigation::Ended MouseNavigation::release() {
  const DragAction action = std::exchange(action_, DragAction::None);
  const bool pressed = std::exchange(pressed_, false), moved = std::exchange(moved_, false);
  view_.unsetCursor();
  if (action == DragAction::Box && moved) {
    band_->hide();
    return Ended::Box;
  }
  return pressed && !moved ? Ended::Click : Ended::Nothing;
}

void MouseNavigation::wheel(const QWheelEvent& event) {
  if (isFromTouchpad(event) && !event.modifiers().testFlag(Qt::ControlModifier)) return camera_.pan(event.pixelDelta());
  const double notches = event.angleDelta().y() / 120.0;
  if (notches != 0) camera_.zoom(event.position(), std::pow(0.86, notches));
}

bool MouseNavigation::zoomByGesture(const QNativeGestureEvent& gesture) {
  if (gesture.gestureType() != Qt::ZoomNativeGesture) return false;
  camera_.zoom(gesture.position(), std::exp(-gesture.value()));
  return true;
}

}  // namespace blossom::ui
