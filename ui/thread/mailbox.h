#pragma once
#include <QObject>
#include <deque>
#include <functional>
#include <mutex>

namespace blossom::ui {

/// Functions handed over to the window's thread, which calls them in the order of their arrival. They wait behind a mutex of
/// the standard library rather than in Qt's event queue: ThreadSanitizer sees this hand-over, but not that of Qt.
class Mailbox : public QObject {
 public:
  using Letter = std::function<void()>;

  /// From any thread. Letters that nobody has read when the mailbox ends are dropped; whoever posts must have ended before.
  void post(Letter);

 protected:
  bool event(QEvent*) override;

 private:
  std::mutex guard_;
  std::deque<Letter> letters_;
  bool announced_ = false;  // an event is under way
};

}  // namespace blossom::ui
