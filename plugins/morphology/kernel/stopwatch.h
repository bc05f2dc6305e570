#pragma once
#include <chrono>

namespace blossom::morphology {

/// Milliseconds of the stages of a computation.
class Stopwatch {
 public:
  /// Milliseconds since the last lap, or since construction.
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
