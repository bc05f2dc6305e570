#pragma once
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

#include "core/parallel.h"

namespace blossom::test {

double secondsOf(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Median of up to 9 runs within two seconds.
double medianSeconds(const auto& work) {
  std::vector<double> times;
  for (double total = 0; times.empty() || (times.size() < 9 && total < 2); total += times.back())
    times.push_back(secondsOf(work));
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

/// How many times as fast all threads are as one. In turns, and the median of all turns: the machine is not always as fast.
double timesOneThread(const auto& work) {
  constexpr int turns = 7;
  std::vector<double> times;
  for (int turn = 0; turn < turns; ++turn) {
    const double all = secondsOf(work);
    setThreadLimit(1);
    times.push_back(secondsOf(work) / all);
    setThreadLimit(0);
  }
  std::nth_element(times.begin(), times.begin() + turns / 2, times.end());
  return times[turns / 2];
}

}  // namespace blossom::test
