#pragma once
#include <functional>
#include <thread>

#include "core/progress.h"

namespace blossom {

/// Handles SIGINT, SIGTERM, SIGQUIT and SIGHUP: cancels the work; at a second signal, or when the work does not stop soon,
/// ends all helper processes, removes temporary files and exits. Create it before any other thread, because threads inherit
/// the signal mask.
class Interruption {
 public:
  /// @param beforeLeaving called before such an exit, to inform the user
  Interruption(CancelToken, std::function<void()> beforeLeaving);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

 private:
  std::thread watcher_;
};

}  // namespace blossom
