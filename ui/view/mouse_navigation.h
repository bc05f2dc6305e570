#pragma once
#include <QObject>
#include <QPointF>
#include <QRectF>
#include <functional>
#include <optional>

#include "core/vector.h"
#include "ui/view/view_navigation.h"

class QNativeGestureEvent;
class QWheelEvent;

namespace blossom::ui {

class CameraControl;
class SelectionBand;

/// What drags, wheel and gestures do in the view: turn, shift and zoom the camera, or span a box to select with.
class MouseNavigation : public QObject {
  Q_OBJECT
 public:
  MouseNavigation(CameraControl&, QWidget& view);

  void setStyle(NavigationStyle style) { style_ = style; }
  [[nodiscard]] NavigationStyle style() const { return style_; }

  /// A drag may begin. @param boxes whether one that selects may; `pivot` finds what the camera turns about
  void press(QPointF at, Qt::MouseButtons, Qt::KeyboardModifiers, bool boxes,
             const std::function<std::optional<Vec3>()>& pivot);
  [[nodiscard]] bool pressed() const { return pressed_; }
  /// Ignores the mouse until it is pressed again.
  void giveUp();
  /// @pre pressed(). False while it is no drag yet.
  bool move(QPointF at);

  enum class Ended { Nothing, Click, Box };
  Ended release();
  /// From where it was pressed, which selects what it touches when it was spanned to the left.
  [[nodiscard]] QRectF box(QPointF to) const { return QRectF(pressedAt_, to).normalized(); }
  [[nodiscard]] bool crossing(QPointF to) const { return to.x() < pressedAt_.x(); }

  void wheel(const QWheelEvent&);
  /// False when the gesture means nothing here.
  bool zoomByGesture(const QNativeGestureEvent&);

 signals:
  void hint(const QString& text);

 private:
  void drag(QPointF at);

  CameraControl& camera_;
  QWidget& view_;
  SelectionBand* band_;
  NavigationStyle style_ = NavigationStyle::Blossom;
  DragAction action_ = DragAction::None;
  bool pressed_ = false, moved_ = false;
  QPointF pressedAt_, lastAt_;
  std::optional<Vec3> pivot_;  // what the camera turns about
};

}  // namespace blossom::ui
