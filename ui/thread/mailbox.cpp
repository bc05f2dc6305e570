#include "ui/thread/mailbox.h"

#include <QCoreApplication>
#include <QEvent>

namespace blossom::ui {

namespace {

QEvent::Type letterType() {
  static const int type = QEvent::registerEventType();
  return static_cast<QEvent::Type>(type);
}

}  // namespace

void Mailbox::post(Letter letter) {
  const std::scoped_lock lock(guard_);
  letters_.push_back(std::move(letter));
  if (announced_) return;
  announced_ = true;
  QCoreApplication::postEvent(this, new QEvent(letterType()));
}

// One letter for each event: input of the user and painting get their turn between them.
bool Mailbox::event(QEvent* event) {
  if (event->type() != letterType()) return QObject::event(event);
  Letter letter;
  {
    const std::scoped_lock lock(guard_);
    letter = std::move(letters_.front());
    letters_.pop_front();
    announced_ = !letters_.empty();
    if (announced_) QCoreApplication::postEvent(this, new QEvent(letterType()));
  }
  letter();  // may be the end of this mailbox
  return true;
}

}  // namespace blossom::ui
