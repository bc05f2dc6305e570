// What the net of a factor looks like.
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "manipulators/factors/factor_net.h"
#include "ui/look/theme.h"

namespace blossom::sweep {

namespace {

constexpr double smallestDot = 2.4, growth = 3.2, needle = 9;  // pixels
constexpr double tick = 6, labelSize = 16;

QColor faded(QColor color, double opacity) {
  color.setAlphaF(static_cast<float>(opacity));
  return color;
}

}  // namespace

void FactorNet::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ui::Theme& colors = ui::theme();
  painter.setPen(QPen(colors.color(hasFocus() ? "control" : "border"), 1));
  painter.setBrush(colors.color("field"));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
  if (layout_.rows() == 0) return;
  paintSupports(painter);
  paintKnots(painter);
  paintPoles(painter);
  paintCandidate(painter);
  if (drag_ != Drag::Frame || !moved_) return;
  painter.setPen(QPen(colors.color("control"), 1, Qt::DashLine));
  painter.setBrush(faded(colors.color("control"), 0.12));
  painter.drawRect(QRectF(pressed_, now_).normalized());
}

/// All together, each place once; what leaves the period comes in at its other end.
void FactorNet::paintSupports(QPainter& painter) const {
  const double period = layout_.domainU.second - layout_.domainU.first;
  QPainterPath reached;
  reached.setFillRule(Qt::WindingFill);
  for (const FactorPole& pole : chosen_) {
    const auto [u0, u1] = layout_.reachU[pole.row];
    const auto [v0, v1] = layout_.reachV[pole.column];
    for (const int turn : {-1, 0, 1}) {
      if (turn != 0 && !layout_.closed) continue;
      const QPointF low = pixelsOf(u0 + turn * period, v0), high = pixelsOf(u1 + turn * period, v1);
      const QRectF part = QRectF(low, high).normalized().intersected(area());
      if (!part.isEmpty()) reached.addRect(part);
    }
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(faded(ui::theme().color("made"), 0.16));
  painter.drawPath(reached);
}

void FactorNet::paintKnots(QPainter& painter) const {
  const QRectF all = area();
  const ui::Theme& colors = ui::theme();
  const auto line = [&](const QPointF& from, const QPointF& to, const QPointF& outside) {
    painter.setPen(QPen(colors.color("line"), 1));
    painter.drawLine(from, to);
    painter.setPen(QPen(colors.color("muted"), 1));
    painter.drawLine(from, from + outside);
  };
  for (const double u : layout_.knotsU) {
    const double x = pixelsOf(u, 0).x();
    line({x, all.bottom()}, {x, all.top()}, {0, tick});
  }
  for (const double v : layout_.knotsV) {
    const double y = pixelsOf(0, v).y();
    line({all.left(), y}, {all.right(), y}, {-tick, 0});
  }
  QFont small = font();
  small.setPixelSize(10);
  painter.setFont(small);
  painter.setPen(colors.color("faint"));
  if (!layout_.knotsU.empty())
    painter.drawText(QRectF(all.left(), all.bottom() + tick + 1, all.width(), labelSize), Qt::AlignRight | Qt::AlignVCenter,
                     QStringLiteral("u →"));
  painter.drawText(QRectF(2, all.top() - 2, labelSize, labelSize), Qt::AlignCenter, QStringLiteral("v ↑"));
}

/// Dots of a dense net are smaller, or they would run into each other.
double FactorNet::dotScale() const {
  constexpr double share = 0.7, smallest = 0.45;
  const auto spacing = [](double length, std::size_t count) {
    return length / static_cast<double>(std::max<std::size_t>(2, count) - 1);
  };
  const double room = std::min(spacing(area().width(), layout_.rows()), spacing(area().height(), layout_.columns()));
  return std::clamp(share * room / (2 * (smallestDot + growth)), smallest, 1.0);
}

void FactorNet::paintPoles(QPainter& painter) const {
  const ui::Theme& colors = ui::theme();
  const double scale = dotScale();
  const auto valueOf = [&](const std::vector<double>& all, std::size_t i, std::size_t j, double otherwise) {
    const std::size_t k = i * layout_.columns() + j;
    return k < all.size() ? all[k] : otherwise;
  };
  for (std::size_t i = 0; i < layout_.rows(); ++i)
    for (std::size_t j = 0; j < layout_.columns(); ++j) {
      const FactorPole pole{i, j};
      const bool chosen = chosen_.contains(pole);
      const QPointF at = pixelsOf(layout_.us[i], layout_.vs[j]);
      const double radius = scale * (smallestDot + growth * valueOf(sizes_, i, j, 0.4));
      const QColor color = colors.color(chosen ? "made" : "control");
      if (!directions_.empty()) {
        const double angle = toRadians(valueOf(directions_, i, j, 0));
        painter.setPen(QPen(color, 1.5));
        painter.drawLine(at, at + scale * needle * QPointF(std::sin(angle), -std::cos(angle)));
      }
      if (under_ == pole) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(faded(color, 0.3));
        painter.drawEllipse(at, radius + 4, radius + 4);
      }
      painter.setPen(QPen(colors.color("field"), 1));
      painter.setBrush(color);
      painter.drawEllipse(at, radius, radius);
    }
}

void FactorNet::paintCandidate(QPainter& painter) const {
  if (!candidate_) return;
  const QRectF all = area();
  painter.setPen(QPen(ui::theme().color("made"), 1, Qt::DashLine));
  if (candidate_->alongU) {
    const double x = pixelsOf(candidate_->at, 0).x();
    painter.drawLine(QPointF(x, all.top()), QPointF(x, all.bottom() + tick));
  } else {
    const double y = pixelsOf(0, candidate_->at).y();
    painter.drawLine(QPointF(all.left() - tick, y), QPointF(all.right(), y));
  }
}

}  // namespace blossom::sweep
