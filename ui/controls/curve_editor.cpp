#include "ui/controls/curve_editor.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/look/text.h"
#include "ui/look/theme.h"

namespace blossom::ui {

namespace {

constexpr double radius = 4;
constexpr double reach = 9;
constexpr QMarginsF margins(10, 10, 10, 10);

}  // namespace

CurveEditor::CurveEditor(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumHeight(110);
  setToolTip(tr("Click to add a point, drag to move it, right click or Delete to remove it"));
}

void CurveEditor::setBounds(std::optional<double> minimum, std::optional<double> maximum) {
  minimum_ = minimum;
  maximum_ = maximum;
}

void CurveEditor::setPoints(std::vector<QPointF> points) {
  points_ = std::move(points);
  dragging_ = false;
  if (chosen_ >= static_cast<int>(points_.size())) chosen_ = static_cast<int>(points_.size()) - 1;
  fitView();
  update();
  emit chosenChanged();
}

void CurveEditor::choose(int index) {
  chosen_ = std::clamp(index, -1, static_cast<int>(points_.size()) - 1);
  update();
  emit chosenChanged();
}

// The plane shows 0..1 and all points, with room to draw beyond the values where no bound forbids it.
void CurveEditor::fitView() {
  double left = 0, right = 1, low = minimum_.value_or(0), high = maximum_.value_or(1);
  for (const QPointF& p : points_) {
    left = std::min(left, p.x());
    right = std::max(right, p.x());
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  const double room = (high - low) * 0.15;
  if (!minimum_ && low < 0) low -= room;
  if (!maximum_) high += room;
  if (high <= low) high = low + 1;
  view_ = QRectF(left, low, right - left, high - low);
}

QPointF CurveEditor::toPixels(const QPointF& p) const {
  const QRectF area = QRectF(rect()).marginsRemoved(margins);
  return {area.left() + (p.x() - view_.left()) / view_.width() * area.width(),
          area.bottom() - (p.y() - view_.top()) / view_.height() * area.height()};
}

QPointF CurveEditor::toValues(const QPointF& pixels) const {
  const QRectF area = QRectF(rect()).marginsRemoved(margins);
  const auto rounded = [](double v) { return std::round(v * 1000) / 1000; };
  return {rounded(view_.left() + (pixels.x() - area.left()) / area.width() * view_.width()),
          rounded(view_.top() + (area.bottom() - pixels.y()) / area.height() * view_.height())};
}

int CurveEditor::pointAt(const QPointF& pixels) const {
  int best = -1;
  double nearest = reach;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const QPointF apart = toPixels(points_[i]) - pixels;
    if (const double distance = std::hypot(apart.x(), apart.y()); distance < nearest) {
      nearest = distance;
      best = static_cast<int>(i);
    }
  }
  return best;
}

/// Between its neighbours and inside the bounds.
QPointF CurveEditor::confined(QPointF p, int index) const {
  const auto at = static_cast<std::size_t>(index);
  const double first = at > 0 ? points_[at - 1].x() : view_.left();
  const double last = at + 1 < points_.size() ? points_[at + 1].x() : view_.right();
  p.setX(std::clamp(p.x(), first, std::max(first, last)));
  if (minimum_) p.setY(std::max(p.y(), *minimum_));
  if (maximum_) p.setY(std::min(p.y(), *maximum_));
  return p;
}

void CurveEditor::paintGrid(QPainter& painter) const {
  const QRectF area = QRectF(rect()).marginsRemoved(margins);
  painter.setPen(QPen(theme().color("line"), 1));
  for (int i = 0; i <= 4; ++i) {
    const double x = area.left() + area.width() * i / 4;
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  }
  if (view_.top() <= 0 && view_.bottom() >= 0) {
    const double zero = toPixels({0, 0}).y();
    painter.drawLine(QPointF(area.left(), zero), QPointF(area.right(), zero));
  }
  QFont small = font();
  small.setPixelSize(9);
  painter.setFont(small);
  painter.setPen(theme().color("faint"));
  painter.drawText(area.adjusted(2, -2, -2, 2), Qt::AlignTop | Qt::AlignLeft, readable(view_.bottom(), 3));
  painter.drawText(area.adjusted(2, -2, -2, 2), Qt::AlignBottom | Qt::AlignLeft, readable(view_.top(), 3));
}

void CurveEditor::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& colors = theme();
  painter.setPen(QPen(colors.color(hasFocus() ? "control" : "border"), 1));
  painter.setBrush(colors.color("field"));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
  paintGrid(painter);
  if (points_.empty()) {
    painter.setPen(colors.color("muted"));
    painter.drawText(rect(), Qt::AlignCenter, tr("click to add a point"));
    return;
  }
  QPainterPath path(toPixels(points_.front()));
  for (const QPointF& p : points_) path.lineTo(toPixels(p));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.color("made"), 1.5));
  painter.drawPath(path);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const bool active = static_cast<int>(i) == chosen_;
    painter.setPen(QPen(colors.color("control"), static_cast<int>(i) == under_ ? 2 : 1.5));
    painter.setBrush(colors.color(active ? "control" : "field"));
    painter.drawEllipse(toPixels(points_[i]), radius, radius);
  }
}

void CurveEditor::mousePressEvent(QMouseEvent* event) {
  const int found = pointAt(event->position());
  if (event->button() == Qt::RightButton && found >= 0) {
    choose(found);
    removeChosen();
    return;
  }
  if (event->button() != Qt::LeftButton) return;
  moved_ = found < 0;
  if (found < 0)
    add(event->position());
  else
    choose(found);
  dragging_ = true;
}

void CurveEditor::add(const QPointF& pixels) {
  QPointF p = toValues(pixels);
  p.setX(std::clamp(p.x(), view_.left(), view_.right()));
  const auto later = [](double t, const QPointF& other) { return t < other.x(); };
  const auto place = std::upper_bound(points_.begin(), points_.end(), p.x(), later);
  const int index = static_cast<int>(place - points_.begin());
  points_.insert(place, p);
  points_[static_cast<std::size_t>(index)] = confined(p, index);
  choose(index);
  emit dragged(points_);
}

void CurveEditor::mouseMoveEvent(QMouseEvent* event) {
  if (!dragging_) {
    const int found = pointAt(event->position());
    if (found != under_) update();
    under_ = found;
    setCursor(found >= 0 ? Qt::SizeAllCursor : Qt::CrossCursor);
    return;
  }
  moved_ = true;
  points_[static_cast<std::size_t>(chosen_)] = confined(toValues(event->position()), chosen_);
  update();
  emit chosenChanged();
  emit dragged(points_);
}

void CurveEditor::mouseReleaseEvent(QMouseEvent*) {
  if (!dragging_) return;
  dragging_ = false;
  if (moved_) emit changed(points_);
}

void CurveEditor::leaveEvent(QEvent*) {
  under_ = -1;
  update();
}

void CurveEditor::removeChosen() {
  if (chosen_ < 0) return;
  points_.erase(points_.begin() + chosen_);
  chosen_ = std::min(chosen_, static_cast<int>(points_.size()) - 1);
  update();
  emit changed(points_);
}

void CurveEditor::keyPressEvent(QKeyEvent* event) {
  const int dx = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
  const int dy = event->key() == Qt::Key_Down ? -1 : event->key() == Qt::Key_Up ? 1 : 0;
  const bool remove = event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace;
  if (chosen_ < 0 || (dx == 0 && dy == 0 && !remove)) return QWidget::keyPressEvent(event);
  if (remove) return removeChosen();
  QPointF& p = points_[static_cast<std::size_t>(chosen_)];
  p = confined(p + QPointF(dx * view_.width() / 100, dy * view_.height() / 100), chosen_);
  update();
  emit changed(points_);
}

}  // namespace blossom::ui
