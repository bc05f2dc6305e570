#include "ui/controls/fitting_scroll.h"

#include <QEvent>
#include <QScrollBar>

namespace blossom::ui {

FittingScroll::FittingScroll(QWidget* column, QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setWidget(column);
  column->installEventFilter(this);
}

QSize FittingScroll::sizeHint() const { return widget()->sizeHint(); }

QSize FittingScroll::minimumSizeHint() const {
  const QSize least = widget()->minimumSizeHint();
  constexpr int aRow = 60;
  return {least.width() + verticalScrollBar()->sizeHint().width(), qMin(least.height(), aRow)};
}

/// The column has become higher or lower.
bool FittingScroll::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace blossom::ui
