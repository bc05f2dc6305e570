#pragma once
#include <QObject>
#include <deque>
#include <functional>
#include <mutex>

namespace blossom::ui {

/// Queue of functions that the window's thread calls in the order of their arrival. It uses a mutex of the standard library
/// rather than Qt's event queue, because ThreadSanitizer does not see the synchronisation of Qt.
class Mailbox : public QObject {
 public:
  using Letter = std::function<void()>;

  /// Callable from any thread. Letters not called when the mailbox is destroyed are dropped; posting threads must have ended
  /// before.
  void post(Letter);

 protected:
  bool event(QEvent*) override;

 private:
  std::mutex guard_;
  std::deque<Letter> letters_;
  bool announced_ = false;  // an event is under way
};

}  // namespace blossom::ui
