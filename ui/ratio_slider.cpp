#include "ui/ratio_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/theme.h"

namespace blossom::ui {

RatioSlider::RatioSlider(QWidget* parent) : QLineEdit(parent) {
  setReadOnly(true);
  setAlignment(Qt::AlignRight);
  setCursor(Qt::SizeHorCursor);
  setContextMenuPolicy(Qt::NoContextMenu);
  connect(this, &QLineEdit::editingFinished, this, [this] {
    if (isReadOnly()) return;
    const QString written = text();
    const bool changed = isModified();
    stopTyping();
    if (changed) emit typed(written);
  });
}

void RatioSlider::setValue(double value) {
  value_ = value;
  stopTyping();
}

void RatioSlider::stopTyping() {
  setReadOnly(true);
  setCursor(Qt::SizeHorCursor);
  deselect();
  setText(QString::number(value_, 'f', 3));
  update();
}

double RatioSlider::valueAt(double x) const {
  return std::clamp(std::round(x / std::max(1, width()) * 1000) / 1000, 0.0, 1.0);
}

void RatioSlider::paintEvent(QPaintEvent* event) {
  QLineEdit::paintEvent(event);
  if (!isReadOnly()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath frame;
  frame.addRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
  painter.setClipPath(frame);
  QColor fill = theme().color("made");
  fill.setAlphaF(0.22F);
  painter.fillRect(QRectF(1, 1, (width() - 2) * value_, height() - 2), fill);
}

void RatioSlider::mousePressEvent(QMouseEvent* event) {
  if (!isReadOnly()) return QLineEdit::mousePressEvent(event);
  setFocus();
  dragging_ = event->button() == Qt::LeftButton;
}

void RatioSlider::mouseMoveEvent(QMouseEvent* event) {
  if (!dragging_) return QLineEdit::mouseMoveEvent(event);
  value_ = valueAt(event->position().x());
  setText(QString::number(value_, 'f', 3));
  update();
  emit dragged(value_);
}

void RatioSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (!dragging_) return QLineEdit::mouseReleaseEvent(event);
  dragging_ = false;
  value_ = valueAt(event->position().x());
  emit chosen(value_);
}

void RatioSlider::mouseDoubleClickEvent(QMouseEvent*) {
  setReadOnly(false);
  setCursor(Qt::IBeamCursor);
  selectAll();
}

void RatioSlider::keyPressEvent(QKeyEvent* event) {
  if (!isReadOnly()) {
    if (event->key() == Qt::Key_Escape)
      stopTyping();
    else
      QLineEdit::keyPressEvent(event);
    return;
  }
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.001 : 0.01;
  if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Down)
    emit chosen(std::max(0.0, value_ - step));
  else if (event->key() == Qt::Key_Right || event->key() == Qt::Key_Up)
    emit chosen(std::min(1.0, value_ + step));
  else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_F2)
    mouseDoubleClickEvent(nullptr);
  else
    event->ignore();
}

}  // namespace blossom::ui
