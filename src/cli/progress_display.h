#pragma once
#include <mutex>
#include <string>

#include "cli/invocation.h"
#include "core/stopwatch.h"

namespace blossom {

/// Shows progress on stderr: a bar on a terminal, plain lines with --progress, else nothing. The bar appears after a short
/// delay, so that short work shows none, and is erased at the end.
class ProgressDisplay {
 public:
  explicit ProgressDisplay(const Invocation&);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// A progress that is shown here and cancelled by the terminal's token.
  [[nodiscard]] Progress progress();

 private:
  void show(double fraction, const std::string& stage);
  void drawBar(double fraction, const std::string& stage);

  const Invocation& invocation_;
  std::mutex mutex_;  // work reports from several threads
  Stopwatch watch_;
  bool drawn_ = false;
  int lastTenth_ = -1;
};

}  // namespace blossom
