#pragma once
#include <atomic>
#include <thread>

#include "core/error.h"
#include "core/progress.h"

namespace blossom::test {

/// Lets no computation pass until it is opened; a computation that waits can be cancelled. Counts both.
struct Gate {
  std::atomic<bool> open = false;
  std::atomic<int> entered = 0, cancelled = 0;

  void pass(const Progress& progress) {
    ++entered;
    try {
      while (!open) {
        progress.check();
        std::this_thread::yield();
      }
    } catch (const Error&) {
      ++cancelled;
      throw;
    }
  }
};

}  // namespace blossom::test
