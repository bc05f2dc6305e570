#include "ui/controls/ratio_slider.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTimerEvent>
#include <algorithm>
#include <cmath>

#include "ui/controls/stepping.h"
#include "ui/controls/wheel_gesture.h"
#include "ui/controls/window_keys.h"
#include "ui/look/theme.h"

namespace blossom::ui {

namespace {

int directionOf(int key) {
  if (key == Qt::Key_Left || key == Qt::Key_Down) return -1;
  return key == Qt::Key_Right || key == Qt::Key_Up ? 1 : 0;
}

bool asksForTyping(int key) { return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_F2; }

/// A key by which a number begins.
bool beginsNumber(const QKeyEvent& event) {
  if ((event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) != Qt::NoModifier) return false;
  const QString written = event.text();
  return !written.isEmpty() && (written[0].isDigit() || QStringLiteral(".,-").contains(written[0]));
}

bool answersKey(const QKeyEvent& event) {
  return directionOf(event.key()) != 0 || asksForTyping(event.key()) || beginsNumber(event);
}

}  // namespace

RatioSlider::RatioSlider(QWidget* parent) : QLineEdit(parent) {
  watchWheel();
  setReadOnly(true);
  setAlignment(Qt::AlignRight);
  setCursor(Qt::SizeHorCursor);
  setContextMenuPolicy(Qt::NoContextMenu);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  connect(this, &QLineEdit::editingFinished, this, [this] {
    if (isReadOnly()) return;
    const QString written = text();
    const bool changed = isModified();
    stopTyping();
    if (changed) emit typed(written);
  });
}

void RatioSlider::setRange(double minimum, double maximum) {
  minimum_ = minimum;
  maximum_ = std::max(maximum, minimum);
}

void RatioSlider::setValue(double value) {
  value_ = value;
  dragging_ = stepping_ = false;
  stopTyping();
}

void RatioSlider::setAbsent(bool absent) { absent_ = absent; }

// Three digits at least; more when the value has them.
void RatioSlider::showValue() {
  const bool fine = std::abs(std::round(value_ * 1000) - value_ * 1000) > 1e-6;
  setText(absent_ ? tr("none") : QString::number(value_, 'f', fine ? 6 : 3));
  update();
}

void RatioSlider::stopTyping() {
  setReadOnly(true);
  setCursor(Qt::SizeHorCursor);
  deselect();
  showValue();
}

void RatioSlider::startTyping() {
  setReadOnly(false);
  setCursor(Qt::IBeamCursor);
  selectAll();
}

double RatioSlider::valueAt(double x) const {
  const double share = std::clamp(x / std::max(1, width()), 0.0, 1.0);
  const double exact = minimum_ + share * (maximum_ - minimum_);
  return std::clamp(std::round(exact * 1000) / 1000, minimum_, maximum_);
}

void RatioSlider::paintEvent(QPaintEvent* event) {
  QLineEdit::paintEvent(event);
  if (!isReadOnly() || absent_) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath frame;
  frame.addRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
  painter.setClipPath(frame);
  QColor fill = theme().color("made");
  fill.setAlphaF(0.22F);
  const double share = maximum_ > minimum_ ? std::clamp((value_ - minimum_) / (maximum_ - minimum_), 0.0, 1.0) : 0;
  painter.fillRect(QRectF(1, 1, (width() - 2) * share, height() - 2), fill);
}

void RatioSlider::mousePressEvent(QMouseEvent* event) {
  if (!isReadOnly()) return QLineEdit::mousePressEvent(event);
  setFocus();
  dragging_ = event->button() == Qt::LeftButton;
  pressedAt_ = event->position();
  moved_ = false;
}

/// A hand is not still while it clicks.
bool RatioSlider::hasMoved(const QPointF& to) {
  moved_ = moved_ || std::abs(to.x() - pressedAt_.x()) >= QApplication::startDragDistance();
  return moved_;
}

void RatioSlider::mouseMoveEvent(QMouseEvent* event) {
  if (!isReadOnly()) return QLineEdit::mouseMoveEvent(event);
  if (!dragging_ || !hasMoved(event->position())) return;
  value_ = valueAt(event->position().x());
  absent_ = false;
  showValue();
  emit dragged(value_);
}

void RatioSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (!isReadOnly()) return QLineEdit::mouseReleaseEvent(event);
  if (!dragging_) return;
  dragging_ = false;
  if (!hasMoved(event->position())) return startTyping();
  absent_ = false;
  value_ = valueAt(event->position().x());
  emit chosen(value_);
}

void RatioSlider::mouseDoubleClickEvent(QMouseEvent*) {
  dragging_ = false;
  startTyping();
}

// A line that is read-only claims no keys of its own: what it answers would go to the shortcuts of the view.
bool RatioSlider::event(QEvent* event) {
  if (wheelTimer_ != 0 && asksForUndo(*event)) endSteps();  // what the wheel did is what undo takes back
  if (dragging_ && moved_ && asksForUndo(*event)) {         // to undo what is not done yet is to leave it
    dragging_ = false;
    emit takenBack();
    event->accept();
    return true;
  }
  if (belongsToTheWindow(*event, *this)) {
    event->ignore();
    return true;
  }
  if (event->type() == QEvent::ShortcutOverride && isReadOnly() && answersKey(static_cast<const QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
  return QLineEdit::event(event);
}

void RatioSlider::keyPressEvent(QKeyEvent* event) {
  if (!isReadOnly()) return QLineEdit::keyPressEvent(event);
  const double size = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.001 : 0.01;
  if (const int direction = directionOf(event->key()); direction != 0)
    step(direction * size);
  else if (asksForTyping(event->key()))
    startTyping();
  else if (beginsNumber(*event)) {
    startTyping();
    QLineEdit::keyPressEvent(event);
  } else
    event->ignore();
}

void RatioSlider::keyReleaseEvent(QKeyEvent* event) {
  if (isReadOnly() && directionOf(event->key()) != 0 && !event->isAutoRepeat()) return endSteps();
  QLineEdit::keyReleaseEvent(event);
}

void RatioSlider::wheelEvent(QWheelEvent* event) {
  if (!wheelMeans(*this) || !isReadOnly()) return event->ignore();
  if (wheelTimer_ != 0) killTimer(wheelTimer_);
  wheelTimer_ = startTimer(wheelRestMs);
  step(event->angleDelta().y() / 120.0 * 0.01);
  event->accept();
}

void RatioSlider::timerEvent(QTimerEvent* event) {
  if (event->timerId() == wheelTimer_)
    endSteps();
  else
    QLineEdit::timerEvent(event);
}

void RatioSlider::focusOutEvent(QFocusEvent* event) {
  endSteps();
  QLineEdit::focusOutEvent(event);
}

void RatioSlider::step(double by) {
  stepping_ = true;
  absent_ = false;
  value_ = std::clamp(std::round((value_ + by) * 1e6) / 1e6, minimum_, maximum_);
  showValue();
  emit dragged(value_);
}

// However many steps: one edit.
void RatioSlider::endSteps() {
  if (wheelTimer_ != 0) killTimer(wheelTimer_);
  wheelTimer_ = 0;
  if (!stepping_) return;
  stepping_ = false;
  emit chosen(value_);
}

}  // namespace blossom::ui
