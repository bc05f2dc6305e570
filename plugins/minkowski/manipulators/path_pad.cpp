#include "manipulators/path_pad.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/look/screen_distance.h"

namespace blossom::minkowski {
namespace {

constexpr double spotReach = 9;                        // pixels
constexpr QMarginsF fieldMargins(22, 14, 14, 22);      // for the names of the axes
constexpr double coarseStep = 0.01, fineStep = 0.001;  // the latter with Ctrl

double roundedTo(double value, double step) { return std::clamp(std::round(value / step) / std::round(1 / step), 0.0, 1.0); }

}  // namespace

PathPad::PathPad(QWidget* parent) : QWidget(parent), path_(Value::array(), 2) {
  setObjectName(QStringLiteral("pathPad"));
  setAccessibleName(tr("Path through the blossom"));
  setToolTip(tr("Drag a point; double-click to put one in, Delete or a right click to take one out"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(sizeHint());
}

void PathPad::setPath(const PathPoints& path) {
  if (dragging() || path == path_) return;
  path_ = path;
  const auto isGone = [&](const std::optional<Spot>& spot) {
    return spot && (spot->point >= path_.points().size() || spot->argument >= path_.arguments());
  };
  if (isGone(chosen_)) chosen_.reset();
  if (isGone(under_)) under_.reset();
  if (square() && chosen_) chosen_->argument = 0;
  if (square() && under_) under_->argument = 0;
  update();
}

void PathPad::setPlace(std::optional<double> u) {
  if (u == place_) return;
  place_ = u;
  update();
}

QRectF PathPad::field() const { return QRectF(rect()).marginsRemoved(fieldMargins); }

QPointF PathPad::toPixels(double right, double up) const {
  const QRectF area = field();
  return {area.left() + right * area.width(), area.bottom() - up * area.height()};
}

QPointF PathPad::toValues(const QPointF& pixels, bool fine) const {
  const QRectF area = field();
  const double step = fine ? fineStep : coarseStep;
  return {roundedTo((pixels.x() - area.left()) / area.width(), step),
          roundedTo((area.bottom() - pixels.y()) / area.height(), step)};
}

QPointF PathPad::pixelsOf(const Spot& spot) const {
  const PathPoints::Point& point = path_.points()[spot.point];
  return square() ? toPixels(point[0], point[1]) : toPixels(path_.placeOf(spot.point), point[spot.argument]);
}

QPointF PathPad::pixelsOf(int point, int argument) const {
  return pixelsOf(Spot{static_cast<std::size_t>(point), static_cast<std::size_t>(argument)});
}

/// The nearest; of several at one place the chosen one, else that of the last argument, which is drawn last.
std::optional<PathPad::Spot> PathPad::spotAt(const QPointF& pixels) const {
  std::optional<Spot> best;
  double nearest = spotReach;
  for (std::size_t k = 0; k < path_.points().size(); ++k)
    for (std::size_t i = 0; i < (square() ? 1 : path_.arguments()); ++i) {
      const QPointF apart = pixelsOf(Spot{k, i}) - pixels;
      const double distance = std::hypot(apart.x(), apart.y());
      if (distance > nearest) continue;
      nearest = distance;
      best = Spot{k, i};
    }
  if (best && chosen_ && pixelsOf(*chosen_) == pixelsOf(*best)) return chosen_;
  return best;
}

/// The way from a point to the next that comes nearest.
std::size_t PathPad::wayNear(const QPointF& pixels) const {
  std::size_t best = 0;
  double nearest = HUGE_VAL;
  for (std::size_t k = 0; k + 1 < path_.points().size(); ++k) {
    const double distance = square() ? ui::distanceToSegment(pixels, pixelsOf(Spot{k, 0}), pixelsOf(Spot{k + 1, 0}))
                                     : std::abs(pixels.x() - (pixelsOf(Spot{k, 0}) + pixelsOf(Spot{k + 1, 0})).x() / 2);
    if (distance >= nearest) continue;
    nearest = distance;
    best = k;
  }
  return best;
}

void PathPad::moveChosen(const QPointF& values) {
  const PathPoints last = path_;
  if (square()) path_.set(chosen_->point, 0, values.x());
  path_.set(chosen_->point, square() ? 1 : chosen_->argument, values.y());
  if (path_ == last) return;
  update();
  emit dragged();
}

/// In the square where the mouse is, else on the curves, of which the nearest one is led through the mouse.
void PathPad::insertAt(const QPointF& pixels) {
  const std::size_t way = path_.points().size() < 2 ? 0 : wayNear(pixels);
  const QPointF values = toValues(pixels, false);
  PathPoints::Point point = square() ? PathPoints::Point{values.x(), values.y()} : path_.at(values.x());
  std::size_t argument = 0;
  if (!square()) {
    const auto away = [&](double value) { return std::abs(value - values.y()); };
    const auto nearest = std::min_element(point.begin(), point.end(), [&](double a, double b) { return away(a) < away(b); });
    argument = static_cast<std::size_t>(nearest - point.begin());
    if (away(*nearest) * field().height() > spotReach) *nearest = values.y();
  }
  path_.insert(way + 1, std::move(point));
  chosen_ = Spot{way + 1, argument};
  update();
  emit changed();
}

void PathPad::removeChosen() {
  if (!chosen_ || dragging()) return;
  path_.remove(chosen_->point);
  chosen_.reset();
  under_.reset();
  update();
  emit changed();
}

void PathPad::cancel() {
  if (!dragging()) return;
  path_ = *std::exchange(before_, std::nullopt);
  update();
}

void PathPad::giveUp() {
  cancel();
  emit reverted();
}

void PathPad::mousePressEvent(QMouseEvent* event) {
  const auto found = spotAt(event->position());
  if (dragging()) return;
  if (event->button() == Qt::LeftButton || found) chosen_ = found;
  update();
  if (!found) return;
  if (event->button() == Qt::RightButton) return removeChosen();
  if (event->button() == Qt::LeftButton) before_ = path_;
}

void PathPad::mouseMoveEvent(QMouseEvent* event) {
  if (dragging()) return moveChosen(toValues(event->position(), event->modifiers().testFlag(Qt::ControlModifier)));
  const auto found = spotAt(event->position());
  if (found != under_) update();
  under_ = found;
  setCursor(!found ? Qt::ArrowCursor : square() ? Qt::SizeAllCursor : Qt::SizeVerCursor);
}

void PathPad::mouseReleaseEvent(QMouseEvent* event) {
  if (!dragging() || event->button() != Qt::LeftButton) return;
  const bool moved = *std::exchange(before_, std::nullopt) != path_;
  if (moved)
    emit changed();
  else
    emit reverted();
}

void PathPad::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !spotAt(event->position())) insertAt(event->position());
}

void PathPad::leaveEvent(QEvent*) {
  under_.reset();
  update();
}

/// Keys that the window would take for its own commands first; Delete always, for it must not take the morph where no point
/// is left that was chosen.
bool PathPad::event(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return QWidget::event(event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool arrow = key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
  const bool edits = (chosen_ && arrow) || key == Qt::Key_Delete || key == Qt::Key_Backspace;
  if (!edits && (key != Qt::Key_Escape || !dragging())) return QWidget::event(event);
  event->accept();
  return true;
}

void PathPad::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Escape && dragging()) return giveUp();
  if (key == Qt::Key_Delete || key == Qt::Key_Backspace) return removeChosen();
  const int right = key == Qt::Key_Left ? -1 : key == Qt::Key_Right ? 1 : 0;
  const int up = key == Qt::Key_Down ? -1 : key == Qt::Key_Up ? 1 : 0;
  if (!chosen_ || dragging() || (right == 0 && up == 0)) return QWidget::keyPressEvent(event);
  const PathPoints before = path_;
  const auto step = [&](std::size_t argument, int by) {
    path_.set(chosen_->point, argument, roundedTo(path_.points()[chosen_->point][argument] + by * coarseStep, fineStep));
  };
  if (square()) step(0, right);
  step(square() ? 1 : chosen_->argument, up);
  update();
  if (path_ != before) emit changed();
}

}  // namespace blossom::minkowski
