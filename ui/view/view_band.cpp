#include "ui/view/view_band.h"

#include <QPainter>

#include "ui/look/theme.h"

namespace blossom::ui {

SelectionBand::SelectionBand(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  hide();
}

void SelectionBand::span(QPointF from, QPointF to) {
  crossing_ = to.x() < from.x();
  setGeometry(QRectF(from, to).normalized().toAlignedRect().adjusted(0, 0, 1, 1));
  show();
  update();
}

void SelectionBand::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QColor line = theme().color(crossing_ ? "made" : "control");
  QColor fill = line;
  fill.setAlphaF(0.12F);
  painter.setPen(QPen(line, 1, crossing_ ? Qt::DashLine : Qt::SolidLine));
  painter.setBrush(fill);
  painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

}  // namespace blossom::ui
