#include "ui/controls/field_label.h"

#include <QApplication>
#include <QMouseEvent>
#include <cstdlib>

namespace blossom::ui {

FieldLabel::FieldLabel(const QString& text, QWidget* parent) : QLabel(text, parent) {
  setObjectName(QStringLiteral("fieldLabel"));
  setWordWrap(true);
}

void FieldLabel::setScrubbable(bool on) {
  scrubbable_ = on;
  if (on)
    setCursor(Qt::SizeHorCursor);
  else
    unsetCursor();
}

void FieldLabel::mousePressEvent(QMouseEvent* event) {
  if (!scrubbable_ || event->button() != Qt::LeftButton) return QLabel::mousePressEvent(event);
  pressed_ = true;
  from_ = event->position().toPoint().x();
}

void FieldLabel::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return QLabel::mouseMoveEvent(event);
  const int moved = event->position().toPoint().x() - from_;
  if (!scrubbing_ && std::abs(moved) >= 3) {
    scrubbing_ = true;
    emit scrubStarted();
  }
  if (scrubbing_) emit scrubbed(moved, event->modifiers());
}

void FieldLabel::mouseReleaseEvent(QMouseEvent* event) {
  if (!pressed_) return QLabel::mouseReleaseEvent(event);
  pressed_ = false;
  const bool dragged = scrubbing_;
  scrubbing_ = false;
  if (dragged)
    emit scrubEnded();
  else
    emit clicked();
}

}  // namespace blossom::ui
