#include "ui/controls/number_line.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QTimerEvent>
#include <QToolTip>
#include <QWheelEvent>

#include "ui/controls/stepping.h"
#include "ui/controls/wheel_gesture.h"
#include "ui/controls/window_keys.h"
#include "ui/look/text.h"

namespace blossom::ui {

namespace {

int stepsOf(int key) {
  switch (key) {
    case Qt::Key_Up:
      return 1;
    case Qt::Key_Down:
      return -1;
    case Qt::Key_PageUp:
      return 10;
    case Qt::Key_PageDown:
      return -10;
    default:
      return 0;
  }
}

}  // namespace

NumberLine::NumberLine(QWidget* parent) : QLineEdit(parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  setMinimumWidth(26);
  leaveKeysToTheWindow(this);
  installEventFilter(this);
  watchWheel();
}

// Within the frame and the margins of QLineEdit, which are not public.
QRect NumberLine::textRect() const {
  constexpr int margin = 2;
  QStyleOptionFrame option;
  initStyleOption(&option);
  return style()
      ->subElementRect(QStyle::SE_LineEditContents, &option, this)
      .marginsRemoved(textMargins())
      .adjusted(margin, 0, -margin, 0);
}

QString NumberLine::shownText() const {
  if (hasFocus() || isModified()) return text();
  const int room = textRect().width();
  return fittingNumber(text(), [&](const QString& each) { return fontMetrics().horizontalAdvance(each) <= room; });
}

// QLineEdit would show the beginning of the text, and so another number.
void NumberLine::paintEvent(QPaintEvent* event) {
  const QString shown = shownText();
  if (shown == text()) return QLineEdit::paintEvent(event);
  QStyleOptionFrame option;
  initStyleOption(&option);
  QPainter painter(this);
  style()->drawPrimitive(QStyle::PE_PanelLineEdit, &option, &painter, this);
  painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Text));
  painter.drawText(textRect(),
                   static_cast<int>(alignment() & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter | Qt::TextSingleLine, shown);
}

bool NumberLine::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || shownText() == text()) return QLineEdit::event(event);
  const QString full = toolTip().isEmpty() ? text() : toolTip() + u'\n' + text();
  QToolTip::showText(static_cast<const QHelpEvent*>(event)->globalPos(), full, this);
  return true;
}

void NumberLine::keyPressEvent(QKeyEvent* event) {
  const int steps = stepsOf(event->key());
  if (steps == 0 || isReadOnly()) return QLineEdit::keyPressEvent(event);
  stepping_ = true;
  emit stepped(steps, event->modifiers());
}

void NumberLine::keyReleaseEvent(QKeyEvent* event) {
  if (stepsOf(event->key()) != 0 && !event->isAutoRepeat()) return endSteps();
  QLineEdit::keyReleaseEvent(event);
}

// Undo takes back what the wheel did so far, which is to be a step of its own first.
bool NumberLine::eventFilter(QObject* watched, QEvent* event) {
  if (wheelTimer_ != 0 && asksForUndo(*event)) endSteps();
  return QLineEdit::eventFilter(watched, event);
}

void NumberLine::wheelEvent(QWheelEvent* event) {
  if (!wheelMeans(*this) || isReadOnly()) return event->ignore();  // the panel scrolls
  if (wheelTimer_ != 0) killTimer(wheelTimer_);
  wheelTimer_ = startTimer(wheelRestMs);
  stepping_ = true;
  // Shift turns the wheel sideways on some desktops.
  const int turned = event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
  emit stepped(turned / 120.0, event->modifiers());
  event->accept();
}

void NumberLine::timerEvent(QTimerEvent* event) {
  if (event->timerId() == wheelTimer_)
    endSteps();
  else
    QLineEdit::timerEvent(event);
}

void NumberLine::focusOutEvent(QFocusEvent* event) {
  endSteps();
  QLineEdit::focusOutEvent(event);
}

void NumberLine::endSteps() {
  if (wheelTimer_ != 0) killTimer(wheelTimer_);
  wheelTimer_ = 0;
  if (!stepping_) return;
  stepping_ = false;
  emit stepsEnded();
}

}  // namespace blossom::ui
