#pragma once
#include <chrono>
#include <mutex>
#include <string>

#include "cli/invocation.h"

namespace blossom {

/// Shows how far the work is on stderr: a bar on a screen, plain lines with --progress, nothing otherwise.
/// Short work stays silent: the bar appears after a moment. The bar is wiped out at the end.
class ProgressDisplay {
 public:
  explicit ProgressDisplay(const Invocation&);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// Reports here and stops when the terminal's token is cancelled.
  [[nodiscard]] Progress progress();

 private:
  void show(double fraction, const std::string& stage);
  void drawBar(double fraction, const std::string& stage);

  const Invocation& invocation_;
  std::mutex mutex_;  // work reports from several threads
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool drawn_ = false;
  int lastTenth_ = -1;
};

}  // namespace blossom
