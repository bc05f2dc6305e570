#include "cli/progress_display.h"

#include <fmt/format.h>

#include <ostream>

namespace blossom {
namespace {
constexpr double silentMs = 300;
constexpr int barWidth = 30;
}  // namespace

ProgressDisplay::ProgressDisplay(const Session& session) : session_(session) {}

ProgressDisplay::~ProgressDisplay() {
  if (drawn_) session_.terminal.err << "\r\033[K" << std::flush;
}

Progress ProgressDisplay::progress() {
  if (!session_.terminal.interactive && !session_.progressLines) return Progress(session_.terminal.cancel);
  return Progress(session_.terminal.cancel, [this](double fraction, const std::string& stage) { show(fraction, stage); });
}

void ProgressDisplay::show(double fraction, const std::string& stage) {
  const std::lock_guard lock(mutex_);
  if (session_.progressLines) {
    const int tenth = static_cast<int>(fraction * 10);
    if (tenth != lastTenth_) session_.terminal.err << fmt::format("{:3.0f} %  {}\n", fraction * 100, stage) << std::flush;
    lastTenth_ = tenth;
  } else if (watch_.elapsedMs() > silentMs) {
    drawBar(fraction, stage);
  }
}

void ProgressDisplay::drawBar(double fraction, const std::string& stage) {
  const int full = static_cast<int>(fraction * barWidth);
  std::string bar;
  for (int i = 0; i < barWidth; ++i) bar += i < full ? "━" : "─";
  session_.terminal.err << fmt::format("\r\033[K{} {:3.0f} %  {}", bar, fraction * 100, stage) << std::flush;
  drawn_ = true;
}

}  // namespace blossom
