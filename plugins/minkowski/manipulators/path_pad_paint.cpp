// How the pad of a path looks.
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "manipulators/path_pad.h"
#include "ui/look/theme.h"
#include "ui/tools/view_props.h"

namespace blossom::minkowski {
namespace {

constexpr double spotRadius = 4, placeRadius = 6;

QFont smallOf(const QFont& font) {
  QFont small = font;
  small.setPixelSize(10);
  return small;
}

}  // namespace

/// From the colour of the controls for the first to that of the result for the last.
QColor PathPad::colorOf(std::size_t argument) const {
  const Look look = ui::theme().look();
  const double last = std::max(1.0, static_cast<double>(path_.arguments()) - 1);
  return ui::qtColor(mixed(look.control, look.made, static_cast<double>(argument) / last));
}

void PathPad::paintField(QPainter& painter) const {
  const ui::Theme& colors = ui::theme();
  painter.setPen(QPen(colors.color(hasFocus() ? "control" : "border"), 1));
  painter.setBrush(colors.color("field"));
  painter.drawRect(field());
  painter.setPen(QPen(colors.color("line"), 1));
  for (int k = 1; k < 4; ++k) {
    painter.drawLine(toPixels(k / 4.0, 0), toPixels(k / 4.0, 1));
    painter.drawLine(toPixels(0, k / 4.0), toPixels(1, k / 4.0));
  }
  painter.setPen(QPen(colors.color("muted"), 1, Qt::DashLine));
  painter.drawLine(toPixels(0, 0), toPixels(1, 1));  // the ordinary morph
  painter.setFont(smallOf(font()));
  painter.setPen(colors.color("muted"));
  const QRectF area = field();
  const QString right = square() ? QStringLiteral("t1") : QStringLiteral("u");
  painter.drawText(QRectF(area.left(), area.bottom() + 4, area.width(), 16), Qt::AlignHCenter | Qt::AlignTop, right);
  const QString up = square() ? QStringLiteral("t2") : QStringLiteral("t");
  painter.drawText(QRectF(0, area.top(), area.left() - 4, area.height()), Qt::AlignRight | Qt::AlignVCenter, up);
}

void PathPad::paintSpot(QPainter& painter, const Spot& spot) const {
  const QColor color = square() ? ui::theme().color("control") : colorOf(spot.argument);
  painter.setPen(QPen(color, under_ == spot ? 2.5 : 1.5));
  painter.setBrush(chosen_ == spot ? color : ui::theme().color("field"));
  painter.drawEllipse(pixelsOf(spot), spotRadius, spotRadius);
}

void PathPad::paintSquare(QPainter& painter) const {
  QPainterPath line(pixelsOf(Spot{0, 0}));
  for (std::size_t k = 1; k < path_.points().size(); ++k) line.lineTo(pixelsOf(Spot{k, 0}));
  painter.setPen(QPen(ui::theme().color("made"), 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(line);
  for (std::size_t k = 0; k < path_.points().size(); ++k) paintSpot(painter, {k, 0});
  if (!place_) return;
  const PathPoints::Point now = path_.at(*place_);
  painter.setPen(QPen(ui::theme().color("made"), 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(toPixels(now[0], now[1]), placeRadius, placeRadius);
}

void PathPad::paintCurves(QPainter& painter) const {
  for (std::size_t i = 0; i < path_.arguments(); ++i) {
    QPainterPath line(pixelsOf(Spot{0, i}));
    for (std::size_t k = 1; k < path_.points().size(); ++k) line.lineTo(pixelsOf(Spot{k, i}));
    if (path_.points().size() == 1) line.lineTo(toPixels(1, path_.points().front()[i]));
    painter.setPen(QPen(colorOf(i), 1.75));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(line);
    for (std::size_t k = 0; k < path_.points().size(); ++k) paintSpot(painter, {k, i});
  }
  if (!place_) return;
  painter.setPen(QPen(ui::theme().color("made"), 1));
  painter.drawLine(toPixels(*place_, 0), toPixels(*place_, 1));
}

void PathPad::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintField(painter);
  if (path_.points().empty() || path_.arguments() == 0) return;
  if (square())
    paintSquare(painter);
  else
    paintCurves(painter);
}

}  // namespace blossom::minkowski
