#include "ui/help/tour.h"

#include <QApplication>
#include <QEvent>
#include <QSettings>
#include <QWidget>

#include "ui/help/tour_bubble.h"

namespace blossom::ui {

namespace {

const QString shownKey = QStringLiteral("tour/shown");

}  // namespace

Tour::Tour(QWidget* window, std::vector<TourStep> steps, std::function<QWidget*()> home)
    : QObject(window), window_(window), all_(std::move(steps)), home_(std::move(home)) {}

Tour::~Tour() {
  delete bubble_;
  delete frame_;
}

bool Tour::running() const { return !bubble_.isNull(); }

TourBubble* Tour::bubble() const { return bubble_; }

bool Tour::shownBefore() { return QSettings().value(shownKey, false).toBool(); }

void Tour::start() {
  if (running() || all_.empty()) return;
  QSettings().setValue(shownKey, true);  // also when it is left half-way
  before_ = QApplication::focusWidget();
  step_ = 0;
  skipPassed();
  frame_ = new TourFrame(window_);
  bubble_ = new TourBubble(window_);
  connect(bubble_, &TourBubble::nextWanted, this, &Tour::next);
  connect(bubble_, &TourBubble::backWanted, this, &Tour::back);
  connect(bubble_, &TourBubble::endWanted, this, &Tour::end);
  window_->installEventFilter(this);
  show();
  bubble_->takeFocus();
}

void Tour::next() {
  if (!running()) return;
  if (step_ + 1 >= all_.size()) return end();
  ++step_;
  show();
  bubble_->takeFocus();
}

void Tour::back() {
  if (!running() || step_ == 0) return;
  --step_;
  show();
  bubble_->takeFocus();
}

void Tour::follow() {
  if (!running()) return;
  const std::size_t before = step_;
  skipPassed();
  if (step_ != before) show();
}

/// There is always one that is shown.
void Tour::skipPassed() {
  while (step_ + 1 < all_.size() && all_[step_].isPassed && all_[step_].isPassed()) ++step_;
}

void Tour::end() {
  if (!running()) return;
  window_->removeEventFilter(this);
  const bool hadKeys = bubble_->isAncestorOf(window_->focusWidget());
  bubble_->hide();
  frame_->hide();
  bubble_->deleteLater();  // may be the sender
  frame_->deleteLater();
  bubble_ = nullptr;
  frame_ = nullptr;
  if (hadKeys) giveKeysBack();
  emit ended();
}

/// Left to Qt they would go to whatever comes next in the window, such as a name that is typed over then.
void Tour::giveKeysBack() {
  QWidget* const to = before_ && before_->isVisible() ? before_.data() : home_ ? home_() : nullptr;
  if (to) to->setFocus();
}

void Tour::show() {
  const TourStep& step = all_[step_];
  bubble_->showStep(step.title, step.text, step_, all_.size());
  place();
  frame_->show();
  frame_->raise();
  bubble_->show();
  bubble_->raise();
}

QRect Tour::targetRect() const {
  const QWidget* target = all_[step_].target ? all_[step_].target() : nullptr;
  if (!target || !target->isVisible()) return {};
  return QRect(target->mapTo(window_, QPoint()), target->size()) & window_->rect();
}

void Tour::place() {
  const QRect target = targetRect();
  frame_->setGeometry(target.isEmpty() ? QRect() : target);
  bubble_->pointAt(target);
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  if (watched == window_ && event->type() == QEvent::Resize)
    QMetaObject::invokeMethod(
        this,
        [this] {
          if (running()) place();
        },
        Qt::QueuedConnection);
  return QObject::eventFilter(watched, event);
}

}  // namespace blossom::ui
