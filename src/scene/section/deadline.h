#pragma once
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/progress.h"

namespace blossom {

/// Work that is worth its result only for a while: its progress is cancelled when the time is over.
class Deadline {
 public:
  explicit Deadline(std::chrono::milliseconds);
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  [[nodiscard]] Progress progress() const { return Progress(token_); }

 private:
  CancelToken token_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool done_ = false;
  std::thread clock_;
};

}  // namespace blossom
