#include "ui/tools/floating_panel.h"

#include <QMouseEvent>
#include <QToolButton>
#include <algorithm>

namespace blossom::ui {

namespace {
constexpr int margin = 14;
}

FloatingPanel::FloatingPanel(QWidget* view, Place place) : QFrame(view), place_(place) {
  setObjectName(QStringLiteral("toolPanel"));
  setCursor(Qt::ArrowCursor);
  if (view) view->installEventFilter(this);
}

QToolButton* FloatingPanel::textButton(const QString& text, const QString& help) {
  auto* made = new QToolButton;
  made->setText(text);
  made->setToolTip(help);
  made->setAccessibleName(help);
  made->setFocusPolicy(Qt::StrongFocus);
  return made;
}

void FloatingPanel::settle() {
  const QWidget* view = parentWidget();
  if (!view) return;
  const QSize size = sizeHint().boundedTo(view->size() - QSize(2 * margin, 2 * margin)).expandedTo(minimumSizeHint());
  resize(size);
  move(placeOf(this->size()));  // its layout may have made it larger
}

QPoint FloatingPanel::placeOf(const QSize& size) const {
  const QSize room = parentWidget()->size() - size;
  if (draggedTo_)
    return {std::clamp(draggedTo_->x(), std::min(room.width(), 0), std::max(room.width(), 0)),
            std::clamp(draggedTo_->y(), std::min(room.height(), 0), std::max(room.height(), 0))};
  if (place_ == Place::UpperLeft) return {std::clamp(room.width(), 0, margin), std::clamp(room.height(), 0, margin)};
  return {room.width() / 2, room.height() - margin};
}

/// Whether it was a mouse event.
bool FloatingPanel::dragged(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      if (const auto* mouse = static_cast<QMouseEvent*>(event); mouse->button() == Qt::LeftButton)
        held_ = mapFromGlobal(mouse->globalPosition().toPoint());
      return true;
    case QEvent::MouseMove:
      if (!held_) return true;
      draggedTo_ = parentWidget()->mapFromGlobal(static_cast<QMouseEvent*>(event)->globalPosition().toPoint()) - *held_;
      settle();
      return true;
    case QEvent::MouseButtonRelease:
      held_.reset();
      return true;
    case QEvent::MouseButtonDblClick:
      draggedTo_.reset();
      settle();
      return true;
    default:
      return event->type() == QEvent::Wheel;
  }
}

bool FloatingPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool resized = event->type() == QEvent::Resize || event->type() == QEvent::Show;
  if (resized && watched == parentWidget()) settle();
  return QFrame::eventFilter(watched, event);
}

bool FloatingPanel::event(QEvent* event) {
  const bool done = QFrame::event(event);
  if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show) settle();
  if (!dragged(event)) return done;
  event->accept();  // what nobody here wants must not turn the camera behind the card
  return true;
}

}  // namespace blossom::ui
