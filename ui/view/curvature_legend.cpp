#include "ui/view/curvature_legend.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

#include "ui/look/theme.h"
#include "ui/tools/view_props.h"

namespace blossom::ui {

namespace {

constexpr double scaleLeft = 4, scaleTop = 40, scaleWidth = 16, scaleHeight = 160;

/// With a minus sign of the width of digits, as in the panel.
QString curvatureText(double value) { return QString::number(value, 'g', 3).replace(u'-', QChar(0x2212)); }

}  // namespace

CurvatureLegend::CurvatureLegend(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFixedSize(sizeHint());
  hide();
}

void CurvatureLegend::showScale(SurfaceDisplay display, const std::optional<CurvatureRange>& range) {
  if (display == display_ && range == range_) return;
  display_ = display;
  range_ = range;
  value_.reset();
  setVisible(range.has_value());
  setAccessibleName(range ? title() : QString());
  update();
}

void CurvatureLegend::setValue(std::optional<double> value) {
  if (value == value_) return;
  value_ = value;
  update();
}

QString CurvatureLegend::title() const {
  switch (display_) {
    case SurfaceDisplay::Gaussian:
      return tr("Gaussian curvature");
    case SurfaceDisplay::Mean:
      return tr("Mean curvature");
    default:
      return tr("Largest curvature");
  }
}

double CurvatureLegend::heightOf(double value) const {
  const double place = (value - range_->low) / (range_->high - range_->low);
  return scaleTop + scaleHeight * (1 - std::clamp(place, 0.0, 1.0));
}

void CurvatureLegend::paintEvent(QPaintEvent*) {
  if (!range_) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QLinearGradient colors(0, scaleTop + scaleHeight, 0, scaleTop);
  for (int i = 0; i <= 16; ++i) colors.setColorAt(i / 16.0, qtColor(curvatureColor(display_, i / 16.0)));
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors);
  painter.drawRoundedRect(QRectF(scaleLeft, scaleTop, scaleWidth, scaleHeight), 2, 2);

  const QColor ink = qtColor(theme().look().curve);
  const QFontMetricsF metrics(font());
  const double line = metrics.height();
  painter.setPen(ink);
  painter.drawText(QRectF(scaleLeft, 0, width() - scaleLeft, line), Qt::AlignLeft | Qt::AlignVCenter, title());
  painter.drawText(QRectF(scaleLeft, line, width() - scaleLeft, line), Qt::AlignLeft | Qt::AlignVCenter,
                   QString::fromUtf8(curvatureUnit(display_)));
  const auto write = [&](double value, double x, const QColor& color) {
    painter.setPen(color);
    painter.drawText(QRectF(x, heightOf(value) - line / 2, width() - x, line), Qt::AlignLeft | Qt::AlignVCenter,
                     curvatureText(value));
  };
  const double beside = scaleLeft + scaleWidth + 10;
  const double middle = (range_->low + range_->high) / 2;
  for (const double value : {range_->low, middle, range_->high})
    if (!value_ || std::abs(heightOf(value) - heightOf(*value_)) > line) write(value, beside, ink);
  if (!value_) return;
  const double y = heightOf(*value_);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  painter.drawPolygon(
      QPolygonF{{scaleLeft + scaleWidth + 1, y}, {scaleLeft + scaleWidth + 7, y - 4}, {scaleLeft + scaleWidth + 7, y + 4}});
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(ink);
  // A value beyond the scale stands at its end, with all its digits.
  painter.drawText(QRectF(beside, y - line / 2, width() - beside, line), Qt::AlignLeft | Qt::AlignVCenter,
                   curvatureText(*value_));
}

}  // namespace blossom::ui
