#include "ui/tools/floating_panel.h"

#include <QEvent>
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
  const QPoint at = place_ == Place::UpperLeft
                        ? QPoint(margin, margin)
                        : QPoint((view->width() - size.width()) / 2, view->height() - size.height() - margin);
  setGeometry(QRect(at, size));
}

bool FloatingPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool resized = event->type() == QEvent::Resize || event->type() == QEvent::Show;
  if (resized && watched == parentWidget()) settle();
  return QFrame::eventFilter(watched, event);
}

bool FloatingPanel::event(QEvent* event) {
  const bool done = QFrame::event(event);
  if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show) settle();
  // What nobody here wants must not turn the camera behind the card.
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
      event->accept();
      return true;
    default:
      return done;
  }
}

}  // namespace blossom::ui
