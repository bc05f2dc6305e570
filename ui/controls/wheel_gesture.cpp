#include "ui/controls/wheel_gesture.h"

#include <QApplication>
#include <QPointer>
#include <QWheelEvent>
#include <QWidget>

namespace blossom::ui {

namespace {

/// Sees every event before the widget that it is for, so it also knows of turns that no field receives.
class WheelGesture final : public QObject {
 public:
  using QObject::QObject;
  [[nodiscard]] bool isFor(const QWidget& field) const { return under_ && owner_ == &field; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    switch (event->type()) {
      case QEvent::Wheel:
        if (auto* widget = qobject_cast<QWidget*>(watched)) follow(*widget, *static_cast<QWheelEvent*>(event));
        break;
      case QEvent::MouseButtonPress:
      case QEvent::FocusIn:
        under_ = false;
        break;
      default:
        break;
    }
    return false;
  }

 private:
  // What a widget leaves goes to its parents at the same time and place: the same gesture.
  void follow(QWidget& widget, const QWheelEvent& event) {
    const quint64 now = event.timestamp();
    const bool moved = (event.globalPosition() - from_).manhattanLength() > QApplication::startDragDistance();
    if (!under_ || moved || now > last_ + wheelPauseMs) {
      under_ = true;
      from_ = event.globalPosition();
      owner_ = widget.hasFocus() ? &widget : nullptr;
    }
    last_ = now;
  }

  bool under_ = false;  // a gesture is under way
  QPointer<QWidget> owner_;
  QPointF from_;
  quint64 last_ = 0;
};

WheelGesture& wheelGesture() {
  static QPointer<WheelGesture> watching;
  if (!watching) {
    watching = new WheelGesture(qApp);
    qApp->installEventFilter(watching);
  }
  return *watching;
}

}  // namespace

void watchWheel() { wheelGesture(); }

bool wheelMeans(const QWidget& field) { return field.hasFocus() && wheelGesture().isFor(field); }

}  // namespace blossom::ui
