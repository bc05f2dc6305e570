#include "ui/thread/background.h"

#include "core/thread_priority.h"

namespace blossom::ui {

Background::~Background() {
  {
    const std::scoped_lock lock(guard_);
    waiting_.clear();
    ending_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Background::start(Work work) {
  {
    const std::scoped_lock lock(guard_);
    waiting_.push_back(std::move(work));
    if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  }
  changed_.notify_all();
}

void Background::drop() {
  const std::scoped_lock lock(guard_);
  waiting_.clear();
}

void Background::run() {
  lowerThreadPriority();
  std::unique_lock lock(guard_);
  for (;;) {
    changed_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
    if (ending_) return;
    Work work = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    work();
    work = nullptr;  // what it holds ends here, not under the lock
    lock.lock();
  }
}

}  // namespace blossom::ui
