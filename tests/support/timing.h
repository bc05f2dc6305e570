#pragma once
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

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

}  // namespace blossom::test
