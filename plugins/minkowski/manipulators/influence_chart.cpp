#include "manipulators/influence_chart.h"

#include <QPainter>
#include <QStringList>
#include <algorithm>
#include <functional>

#include "kernel/morph/evaluation_order.h"
#include "kernel/morph/influence_curves.h"
#include "manipulators/control_colors.h"
#include "ui/look/theme.h"
#include "ui/tools/view_props.h"

namespace blossom::minkowski {
namespace {

constexpr std::size_t intervalsDrawn = 100;
constexpr double dotRadius = 3, curveWidth = 1.75;
constexpr QSize chartSize(240, 96);
constexpr QMarginsF chartMargins(5, 5, 5, 5);

}  // namespace

InfluenceChart::InfluenceChart(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("influenceChart"));
  setAccessibleName(tr("Influence of each control shape over t"));
  setFixedSize(chartSize);
  connect(&ui::ThemeManager::instance(), &ui::ThemeManager::changed, this, [this] { update(); });
}

QSize InfluenceChart::sizeHint() const { return chartSize; }

void InfluenceChart::setMorph(const ShapeKnots& spline, const std::vector<double>& levels) {
  if (spline != spline_) {
    spline_ = spline;
    curves_.clear();
    const InfluenceCurves influences = influenceCurves(spline, intervalsDrawn);
    for (const std::vector<double>& shares : influences.shares) {
      QPolygonF& curve = curves_.emplace_back();
      for (std::size_t k = 0; k < shares.size(); ++k) curve << QPointF(influences.times[k], shares[k]);
    }
  }
  const bool same = std::adjacent_find(levels.begin(), levels.end(), std::not_equal_to<>()) == levels.end();
  const bool isOnChart = same && !levels.empty() && levels.front() >= 0 && levels.front() <= 1;
  cursor_ = isOnChart ? std::optional(levels.front()) : std::nullopt;
  shares_ = cursor_ ? influences(spline_, *cursor_) : sharesOf(levels);
  tellShares();
  update();
}

void InfluenceChart::tellShares() {
  QStringList lines;
  for (std::size_t i = 0; i < shares_.size(); ++i)
    lines << QStringLiteral("%1: %2 %").arg(i + 1).arg(100 * shares_[i], 0, 'f', 1);
  setToolTip(lines.join(u'\n'));
  setAccessibleDescription(lines.join(QStringLiteral(", ")));
}

QVariantList InfluenceChart::curves() const {
  QVariantList list;
  for (const QPolygonF& curve : curves_) list << QVariant::fromValue(curve);
  return list;
}

QVariant InfluenceChart::cursor() const { return cursor_ ? QVariant(*cursor_) : QVariant(); }

QVariantList InfluenceChart::shares() const {
  QVariantList list;
  for (const double share : shares_) list << share;
  return list;
}

QVariantList InfluenceChart::colors() const {
  QVariantList list;
  for (std::size_t i = 0; i < curves_.size(); ++i) list << colorOf(i);
  return list;
}

QColor InfluenceChart::colorOf(std::size_t shape) { return ui::qtColor(controlColor(ui::theme().look(), shape)); }

QRectF InfluenceChart::plane() const { return QRectF(rect()).marginsRemoved(chartMargins); }

QPointF InfluenceChart::pixelOf(const QPointF& value) const {
  const QRectF area = plane();
  return {area.left() + value.x() * area.width(), area.bottom() - value.y() * area.height()};
}

void InfluenceChart::paintEvent(QPaintEvent*) {
  const Look look = ui::theme().look();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(ui::qtColor(look.grid), 1));
  painter.drawRect(plane());
  if (cursor_) {
    painter.setPen(QPen(ui::qtColor(look.made), 1));
    painter.drawLine(pixelOf({*cursor_, 0}), pixelOf({*cursor_, 1}));
  }
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const QColor color = colorOf(i);
    QPolygonF line;
    for (const QPointF& value : curves_[i]) line << pixelOf(value);
    painter.setPen(QPen(color, curveWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
    if (!cursor_ || i >= shares_.size()) continue;
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawEllipse(pixelOf({*cursor_, shares_[i]}), dotRadius, dotRadius);
  }
}

}  // namespace blossom::minkowski
