#pragma once
#include <functional>
#include <thread>

#include "core/progress.h"

namespace blossom {

/// Ends the program at SIGINT, SIGTERM, SIGQUIT and SIGHUP: asks the work to stop, and where it does not do so soon, or at a
/// second signal, ends all helper processes, removes what is temporary and leaves. To be made before any other thread,
/// because threads inherit that these signals wait for this one.
class Interruption {
 public:
  /// @param beforeLeaving tells the user, where the work itself cannot
  Interruption(CancelToken, std::function<void()> beforeLeaving);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

 private:
  std::thread watcher_;
};

}  // namespace blossom
