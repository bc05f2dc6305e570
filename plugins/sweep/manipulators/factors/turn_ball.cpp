#include "manipulators/factors/turn_ball.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "kernel/quaternion.h"
#include "manipulators/factors/axis_colors.h"
#include "ui/look/theme.h"
#include "ui/plugin/tool.h"

namespace blossom::sweep {

namespace {

constexpr double rim = 0.85;  // share of the radius outside of which a drag turns about the line of sight

}  // namespace

TurnBall::TurnBall(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("turnBall"));
  setAccessibleName(tr("Trackball"));
  setToolTip(tr("Drag to turn the chosen poles as the view sees them; along the rim, about the line of sight"));
  setFocusPolicy(Qt::StrongFocus);
  setFixedSize(sizeHint());
}

void TurnBall::setFrame(const Vec4& orientation) {
  orientation_ = orientation;
  update();
}

void TurnBall::setFacing(const Facing& to) {
  facing_ = to;
  update();
}

double TurnBall::radius() const { return std::min(width(), height()) / 2.0 - 4; }

QPointF TurnBall::fromMiddle(const QPointF& at) const {
  const QPointF off = at - QRectF(rect()).center();
  return {off.x(), -off.y()};
}

Vec3 TurnBall::turnTo(const QPointF& at) const {
  const QPointF from = fromMiddle(pressed_), to = fromMiddle(at);
  if (std::hypot(from.x(), from.y()) > rim * radius()) {
    const double angle = std::remainder(std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x()), 2 * std::numbers::pi);
    return angle * facing_.right.cross(facing_.up);
  }
  const QPointF by = (to - from) / radius();
  return by.x() * facing_.up - by.y() * facing_.right;
}

void TurnBall::mousePressEvent(QMouseEvent* event) {
  event->accept();
  if (event->button() != Qt::LeftButton || !isEnabled()) return;
  pressed_ = event->position();
  held_ = true;
  moved_ = false;
}

void TurnBall::mouseMoveEvent(QMouseEvent* event) {
  event->accept();
  if (!held_) return;
  moved_ = moved_ || (event->position() - pressed_).manhattanLength() >= ui::clickReach;
  if (moved_) emit turned(turnTo(event->position()));
}

void TurnBall::mouseReleaseEvent(QMouseEvent* event) {
  event->accept();
  if (event->button() != Qt::LeftButton || !std::exchange(held_, false)) return;
  if (moved_) emit dropped();
}

void TurnBall::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !std::exchange(held_, false)) return QWidget::keyPressEvent(event);
  emit cancelled();
}

bool TurnBall::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && held_ && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
    event->accept();
  return QWidget::event(event);
}

void TurnBall::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ui::Theme& colors = ui::theme();
  const QPointF middle = QRectF(rect()).center();
  painter.setPen(QPen(colors.color(hasFocus() ? "control" : "border"), 1.2));
  painter.setBrush(colors.color("field"));
  painter.drawEllipse(middle, radius(), radius());
  painter.setPen(QPen(colors.color("line"), 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(middle, rim * radius(), rim * radius());
  if (!(orientation_.squaredNorm() > 0) || !isEnabled()) return;
  const Vec3 back = facing_.right.cross(facing_.up);
  std::array<std::pair<Vec3, int>, 3> axes;
  for (int k = 0; k < 3; ++k) axes[static_cast<std::size_t>(k)] = {sweep::turned(orientation_, Vec3::Unit(k)), k};
  // The nearest is drawn last.
  std::sort(axes.begin(), axes.end(), [&](const auto& a, const auto& b) { return a.first.dot(back) < b.first.dot(back); });
  for (const auto& [axis, k] : axes) {
    const QPointF end = middle + 0.8 * radius() * QPointF(axis.dot(facing_.right), -axis.dot(facing_.up));
    QColor color = axisColor(k);
    if (axis.dot(back) < 0) color.setAlphaF(0.5F);
    painter.setPen(QPen(color, 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(middle, end);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawEllipse(end, 2.6, 2.6);
  }
}

}  // namespace blossom::sweep
