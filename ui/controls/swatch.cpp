#include "ui/controls/swatch.h"

#include <QPainter>

#include "ui/look/theme.h"

namespace blossom::ui {

Swatch::Swatch(QWidget* parent) : QAbstractButton(parent) {
  setFixedSize(sizeHint());
  setCursor(Qt::PointingHandCursor);
  setToolTip(tr("Choose another colour"));
  setFocusPolicy(Qt::StrongFocus);
}

void Swatch::setColor(const QColor& color) {
  color_ = color;
  update();
}

void Swatch::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF field = QRectF(rect()).adjusted(2.5, 3.5, -2.5, -3.5);
  painter.setPen(QPen(theme().color(hasFocus() ? "control" : "border"), hasFocus() ? 1.5 : 1));
  painter.setBrush(color_.isValid() ? QBrush(color_) : QBrush(theme().color("faint"), Qt::BDiagPattern));
  painter.drawRoundedRect(field, 4, 4);
}

}  // namespace blossom::ui
