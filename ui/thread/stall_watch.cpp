#include "ui/thread/stall_watch.h"

#include <pthread.h>
#include <time.h>

#include <QtGlobal>
#include <chrono>
#include <cstdio>

namespace blossom::ui {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds interval(4);

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double computingOf(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

}  // namespace

StallWatch::StallWatch() {
  thread_ = std::thread([this, window = ::pthread_self()] {
    clockid_t clock{};
    if (::pthread_getcpuclockid(window, &clock) != 0) clock = CLOCK_MONOTONIC;
    while (!ending_) {
      const bool working = works_ > 0;
      const Clock::time_point asked = Clock::now();
      const double busyBefore = computingOf(clock);
      answered_ = false;
      if (ending_) return;
      receiver_.post([this] { answer(); });
      answered_.wait(false);
      const double wall = millisecondsSince(asked), busy = computingOf(clock) - busyBefore;
      overall_.keep(wall, busy);
      if (working || works_ > 0) work_.keep(wall, busy);
      std::this_thread::sleep_for(interval);  // the window shall have something else to do, too
    }
  });
}

StallWatch::~StallWatch() {
  ending_ = true;
  answer();  // nobody takes the token any more
  thread_.join();
}

void StallWatch::answer() {
  answered_ = true;
  answered_.notify_all();
}

void StallWatch::Kept::keep(double wallMs, double busyMs) {
  if (wallMs > wall) wall = wallMs;
  if (busyMs > busy) busy = busyMs;
}

void StallWatch::reset() {
  for (Kept* kept : {&overall_, &work_}) kept->wall = kept->busy = 0;
}

void StallWatch::print() const {
  std::fprintf(stderr, "figure longest_stall_ms %.1f\n", work_.wall.load());
  std::fprintf(stderr, "figure longest_stall_computing_ms %.1f\n", work_.busy.load());
  std::fprintf(stderr, "figure longest_stall_without_work_ms %.1f\n", overall_.wall.load());
}

bool StallWatch::wanted() { return qEnvironmentVariableIsSet("BLOSSOM_STALL_WATCH"); }

}  // namespace blossom::ui
