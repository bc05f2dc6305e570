#pragma once
#include <mutex>
#include <string>

#include "cli/session.h"
#include "core/stopwatch.h"

namespace blossom {

/// Shows how far the work is on stderr: a bar on a screen, plain lines with --progress, nothing otherwise.
/// Short work stays silent: the bar appears after a moment. The bar is wiped out at the end.
class ProgressDisplay {
 public:
  explicit ProgressDisplay(const Session&);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// Reports here and stops when the terminal's token is cancelled.
  [[nodiscard]] Progress progress();

 private:
  void show(double fraction, const std::string& stage);
  void drawBar(double fraction, const std::string& stage);

  const Session& session_;
  std::mutex mutex_;  // work reports from several threads
  Stopwatch watch_;
  bool drawn_ = false;
  int lastTenth_ = -1;
};

}  // namespace blossom
