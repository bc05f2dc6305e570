#pragma once
#include <chrono>

namespace blossom::morphology {

/// Milliseconds of the stages of a computation.
class Stopwatch {
 public:
  /// Since the last lap, or since it was made.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return ms;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace blossom::morphology
