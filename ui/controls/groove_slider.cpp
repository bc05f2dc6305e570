#include "ui/controls/groove_slider.h"

#include <QMouseEvent>
#include <QStyleOptionSlider>

namespace blossom::ui {

GrooveSlider::GrooveSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {}

QRect GrooveSlider::part(QStyle::SubControl control) const {
  QStyleOptionSlider option;
  initStyleOption(&option);
  return style()->subControlRect(QStyle::CC_Slider, &option, control, this);
}

void GrooveSlider::follow(int x) {
  const QRect groove = part(QStyle::SC_SliderGroove);
  const int handle = part(QStyle::SC_SliderHandle).width();
  const int along = x - grabbed_ - groove.left() - handle / 2;
  QStyleOptionSlider option;
  initStyleOption(&option);
  setSliderPosition(
      QStyle::sliderValueFromPosition(minimum(), maximum(), along, groove.width() - handle, option.upsideDown));
}

double GrooveSlider::pixelAt(double way) const {
  const QRect groove = part(QStyle::SC_SliderGroove);
  const int handle = part(QStyle::SC_SliderHandle).width();
  return groove.left() + handle / 2.0 + way * (groove.width() - handle);
}

double GrooveSlider::wayAt(double pixel) const {
  const double first = pixelAt(0), last = pixelAt(1);
  return last > first ? (pixel - first) / (last - first) : 0;
}

void GrooveSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  const QPoint at = event->position().toPoint();
  const QRect handle = part(QStyle::SC_SliderHandle);
  grabbed_ = handle.contains(at) ? at.x() - handle.left() - handle.width() / 2 : 0;
  setSliderDown(true);
  follow(at.x());
}

void GrooveSlider::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown()) follow(event->position().toPoint().x());
}

void GrooveSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) setSliderDown(false);
}

}  // namespace blossom::ui
