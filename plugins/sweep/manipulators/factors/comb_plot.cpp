#include "manipulators/factors/comb_plot.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/look/text.h"
#include "ui/look/theme.h"

namespace blossom::sweep {

namespace {

constexpr double titleHeight = 30, rangeTop = 13, toothPixels = 24;  // the title, and below it the range

}  // namespace

CombPlot::CombPlot(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("combPlot"));
  setMinimumHeight(97);
}

void CombPlot::setCurves(const QString& what, std::vector<CombCurve> curves, double mark) {
  what_ = what;
  curves_ = std::move(curves);
  mark_ = mark;
  setAccessibleName(what);
  setToolTip(what);
  fitScale();
  update();
}

void CombPlot::fitScale() {
  left_ = right_ = low_ = high_ = tallest_ = 0;
  bool first = true;
  for (const CombCurve& curve : curves_) {
    for (const QPointF& p : curve.points) {
      if (std::exchange(first, false)) left_ = right_ = p.x(), low_ = high_ = p.y();
      left_ = std::min(left_, p.x()), right_ = std::max(right_, p.x());
      low_ = std::min(low_, p.y()), high_ = std::max(high_, p.y());
    }
    if (curve.teeth.empty()) low_ = std::min(low_, 0.0);
    for (const double tooth : curve.teeth) tallest_ = std::max(tallest_, std::abs(tooth));
  }
  if (!(right_ > left_)) right_ = left_ + 1;
  // What is constant lies in the middle, whatever its rounding.
  const double size = std::max(std::abs(low_), std::abs(high_));
  constexpr double hardly = 1e-9;
  const bool constant = high_ - low_ <= hardly * size || size == 0;
  range_ = constant ? ui::readable((low_ + high_) / 2, 3)
                    : QStringLiteral("%1 … %2").arg(ui::readable(ui::withoutNoise(low_, size), 3),
                                                    ui::readable(ui::withoutNoise(high_, size), 3));
  if (constant) low_ -= 0.5 + 0.5 * size, high_ += 0.5 + 0.5 * size;
  if (tallest_ <= hardly * size) tallest_ = 0;
}

QPointF CombPlot::pixelsOf(const QPointF& p) const {
  const double room = tallest_ > 0 ? toothPixels : 4;
  const QRectF all = QRectF(rect()).adjusted(24, titleHeight + room, -12, -room - 2);
  return {all.left() + (p.x() - left_) / (right_ - left_) * all.width(),
          all.bottom() - (p.y() - low_) / (high_ - low_) * all.height()};
}

void CombPlot::paintCurve(QPainter& painter, const CombCurve& curve) const {
  QPolygonF line, ends;
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    const QPointF at = pixelsOf(curve.points[k]);
    line << at;
    if (curve.teeth.empty())
      ends << pixelsOf({curve.points[k].x(), 0});
    else if (tallest_ > 0)  // on the outer side, as a comb on a curve in space
      ends << at + QPointF(0, toothPixels * curve.teeth[k] / tallest_);
  }
  QColor faint = curve.color;
  faint.setAlphaF(0.45F);
  painter.setPen(QPen(faint, 1));
  for (qsizetype k = 0; k < ends.size(); k += 2) painter.drawLine(line[k], ends[k]);
  if (!curve.teeth.empty()) painter.drawPolyline(ends);
  painter.setPen(QPen(curve.color, 1.6));
  painter.drawPolyline(line);
}

void CombPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ui::Theme& colors = ui::theme();
  painter.setPen(QPen(colors.color("border"), 1));
  painter.setBrush(colors.color("field"));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
  QFont small = font();
  small.setPixelSize(10);
  painter.setFont(small);
  painter.setPen(colors.color("muted"));
  const QRectF text = QRectF(rect()).adjusted(8, 3, -8, -3);
  painter.drawText(text, Qt::AlignTop | Qt::AlignLeft, shownTitle(painter.fontMetrics(), static_cast<int>(text.width())));
  if (curves_.empty()) return;
  painter.setPen(QPen(colors.color("made"), 1, Qt::DotLine));
  const double x = pixelsOf({mark_, 0}).x();
  painter.drawLine(QPointF(x, titleHeight), QPointF(x, height() - 3));
  for (const CombCurve& curve : curves_) paintCurve(painter, curve);
  painter.setPen(colors.color("faint"));
  painter.drawText(text.adjusted(0, rangeTop, 0, 0), Qt::AlignTop | Qt::AlignRight, range_);
}

/// What it is, and at which parameter, stand at its ends.
QString CombPlot::shownTitle(const QFontMetrics& metrics, int width) const {
  return metrics.elidedText(what_, Qt::ElideMiddle, width);
}

}  // namespace blossom::sweep
