#pragma once
#include <atomic>
#include <thread>

#include "ui/thread/mailbox.h"

namespace blossom::ui {

/// Measures how long the window's thread did not respond: a thread sends it a token every few milliseconds and measures when
/// it is received. Stalls during background work (a job, an evaluation) are recorded separately, because users notice those.
class StallWatch {
 public:
  StallWatch();
  ~StallWatch();
  StallWatch(const StallWatch&) = delete;
  StallWatch& operator=(const StallWatch&) = delete;

  struct Longest {
    double wall = 0;  ///< ms until the thread answered
    double busy = 0;  ///< ms of CPU time of the thread meanwhile, without other processes
  };
  [[nodiscard]] Longest overall() const { return {overall_.wall, overall_.busy}; }
  [[nodiscard]] Longest duringWork() const { return {work_.wall, work_.busy}; }
  void reset();
  /// Prints "figure longest_stall_ms X" and its like to the standard error.
  void print() const;
  /// Whether BLOSSOM_STALL_WATCH is set.
  static bool wanted();

  /// Marks background work during its lifetime.
  class Work {
   public:
    Work() { ++works_; }
    ~Work() { --works_; }
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;
  };

 private:
  struct Kept {
    std::atomic<double> wall = 0, busy = 0;
    void keep(double wallMs, double busyMs);
  };
  void answer();

  static inline std::atomic<int> works_ = 0;
  Mailbox receiver_;  // in the window's thread
  Kept overall_, work_;
  std::atomic<bool> ending_ = false, answered_ = true;
  std::thread thread_;
};

}  // namespace blossom::ui
