#include "scene/section/deadline.h"

namespace blossom {

Deadline::Deadline(std::chrono::milliseconds time)
    : clock_([this, time] {
        std::unique_lock lock(mutex_);
        if (!ended_.wait_for(lock, time, [this] { return done_; })) token_.cancel();
      }) {}

Deadline::~Deadline() {
  {
    const std::scoped_lock lock(mutex_);
    done_ = true;
  }
  ended_.notify_one();
  clock_.join();
}

}  // namespace blossom
