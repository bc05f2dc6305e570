#include "ui/timeline/key_marks.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/controls/groove_slider.h"
#include "ui/look/theme.h"

namespace blossom::ui {

namespace {

constexpr double markSize = 4.5, markReach = 7;

}  // namespace

KeyMarks::KeyMarks(const GrooveSlider& slider, QWidget* parent) : QWidget(parent), slider_(slider) {
  setObjectName(QStringLiteral("keyMarks"));
  setAccessibleName(tr("Keys"));
  setToolTip(tr("Drag a key to another frame; double-click to set one, Delete or a right click to remove one"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setFixedHeight(sizeHint().height());
}

void KeyMarks::setKeys(std::vector<int> frames, int count) {
  if (held_ && (frames.size() != frames_.size() || frames[*held_] != frames_[*held_])) held_.reset();  // not by this drag
  frames_ = std::move(frames);
  count_ = count;
  if (chosen_ && *chosen_ >= frames_.size()) chosen_.reset();
  under_.reset();
  update();
}

double KeyMarks::pixelOf(int frame) const {
  return slider_.pixelAt(count_ < 2 ? 0 : static_cast<double>(frame - 1) / (count_ - 1)) + slider_.x() - x();
}

QPoint KeyMarks::placeOf(int frame) const { return {static_cast<int>(std::lround(pixelOf(frame))), height() / 2}; }

int KeyMarks::frameAt(double pixel) const {
  const double way = slider_.wayAt(pixel - slider_.x() + x());
  return std::clamp(static_cast<int>(std::lround(way * (count_ - 1))) + 1, 1, std::max(count_, 1));
}

std::optional<std::size_t> KeyMarks::keyAt(double pixel) const {
  std::optional<std::size_t> best;
  double nearest = markReach;
  for (std::size_t k = 0; k < frames_.size(); ++k) {
    const double distance = std::abs(pixelOf(frames_[k]) - pixel);
    if (frames_[k] > count_ || distance > nearest) continue;
    nearest = distance;
    best = k;
  }
  return best;
}

int KeyMarks::roomFor(std::size_t key, int frame) const {
  int lowest = 1, highest = count_;
  for (const int other : frames_) {
    if (other < frames_[key]) lowest = std::max(lowest, other + 1);
    if (other > frames_[key]) highest = std::min(highest, other - 1);
  }
  return std::clamp(frame, lowest, std::max(lowest, highest));
}

void KeyMarks::mousePressEvent(QMouseEvent* event) {
  if (held_) return;
  const auto found = keyAt(event->position().x());
  chosen_ = found;
  update();
  if (!found) return;
  if (event->button() == Qt::RightButton) emit removed(static_cast<int>(*found));
  if (event->button() != Qt::LeftButton) return;
  held_ = found;
  heldFrom_ = frames_[*found];
}

void KeyMarks::mouseMoveEvent(QMouseEvent* event) {
  if (!held_) {
    const auto found = keyAt(event->position().x());
    if (found != under_) update();
    under_ = found;
    setCursor(found ? Qt::SizeHorCursor : Qt::ArrowCursor);
    return;
  }
  const int frame = roomFor(*held_, frameAt(event->position().x()));
  if (frame == frames_[*held_]) return;
  frames_[*held_] = frame;
  update();
  emit dragged(static_cast<int>(*held_), frame);
}

void KeyMarks::mouseReleaseEvent(QMouseEvent* event) {
  if (!held_ || event->button() != Qt::LeftButton) return;
  const std::size_t key = *std::exchange(held_, std::nullopt);
  const int frame = frames_[key];
  if (frame != heldFrom_) return emit moved(static_cast<int>(key), frame);
  emit reverted();
  emit clicked(frame);
}

void KeyMarks::mouseDoubleClickEvent(QMouseEvent* event) {
  const double pixel = event->position().x();
  if (event->button() == Qt::LeftButton && !keyAt(pixel)) emit added(frameAt(pixel));
}

void KeyMarks::leaveEvent(QEvent*) {
  under_.reset();
  update();
}

/// No button is released over what is not seen.
void KeyMarks::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  chosen_.reset();
  under_.reset();
  if (held_) giveUp();
}

void KeyMarks::giveUp() {
  frames_[*std::exchange(held_, std::nullopt)] = heldFrom_;
  update();
  emit reverted();
}

/// Keys that the window would take for its own commands first; Delete always, for it must not take the selected feature
/// where no key is left that was chosen.
bool KeyMarks::event(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return QWidget::event(event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool removes = key == Qt::Key_Delete || key == Qt::Key_Backspace;
  const bool edits = removes || (chosen_ && (key == Qt::Key_Left || key == Qt::Key_Right));
  if (!edits && (!held_ || key != Qt::Key_Escape)) return QWidget::event(event);
  event->accept();
  return true;
}

void KeyMarks::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (held_ && key == Qt::Key_Escape) return giveUp();
  const int by = key == Qt::Key_Left ? -1 : key == Qt::Key_Right ? 1 : 0;
  const bool removes = key == Qt::Key_Delete || key == Qt::Key_Backspace;
  if (removes && (held_ || !chosen_)) return;
  if (held_ || !chosen_ || (by == 0 && !removes)) return QWidget::keyPressEvent(event);
  const int number = static_cast<int>(*chosen_);
  if (removes) return emit removed(number);
  const int frame = roomFor(*chosen_, frames_[*chosen_] + by);
  if (frame != frames_[*chosen_]) emit moved(number, frame);
}

void KeyMarks::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor color = theme().color("control");
  for (std::size_t k = 0; k < frames_.size(); ++k) {
    if (frames_[k] > count_) continue;
    const QPointF middle(pixelOf(frames_[k]), height() / 2.0);
    const std::array<QPointF, 4> corners{middle + QPointF(0, -markSize), middle + QPointF(markSize, 0),
                                         middle + QPointF(0, markSize), middle + QPointF(-markSize, 0)};
    painter.setPen(QPen(color, under_ == k || held_ == k ? 2 : 1.2));
    painter.setBrush(chosen_ == k ? color : theme().color("bar"));
    painter.drawConvexPolygon(corners.data(), static_cast<int>(corners.size()));
  }
}

}  // namespace blossom::ui
