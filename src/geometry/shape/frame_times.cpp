#include "geometry/shape/frame_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace blossom {

std::vector<double> frameBeginnings(const Sequence& sequence) {
  const std::size_t count = sequence.frames.size();
  const bool timed = count > 0 && sequence.times.size() == count && sequence.times.back() > sequence.times.front();
  const double span = timed ? sequence.times.back() - sequence.times.front() : static_cast<double>(count) - 1;
  const double whole = count > 1 ? span * static_cast<double>(count) / (static_cast<double>(count) - 1) : 1;
  std::vector<double> begins;
  for (std::size_t k = 0; k < count; ++k)
    begins.push_back((timed ? sequence.times[k] - sequence.times.front() : static_cast<double>(k)) / whole);
  return begins;
}

std::size_t frameAt(const std::vector<double>& beginnings, double share) {
  const auto next = std::upper_bound(beginnings.begin(), beginnings.end(), share);
  return next == beginnings.begin() ? 0 : static_cast<std::size_t>(next - beginnings.begin()) - 1;
}

std::string frameLabel(const Sequence& sequence, std::size_t frame) {
  if (sequence.times.size() != sequence.frames.size()) return fmt::format("{}", frame + 1);
  const double shown = std::round(sequence.times[frame] * 1000) / 1000;
  return fmt::format("{}", shown == 0 ? 0.0 : shown);  // no "-0"
}

std::vector<std::size_t> spreadFrames(std::size_t count, std::size_t wanted) {
  const std::size_t chosen = std::min(count, wanted);
  std::vector<std::size_t> frames;
  frames.reserve(chosen);
  // Rounded to the nearest, so that the gaps differ by one at most.
  for (std::size_t k = 0; k < chosen; ++k)
    frames.push_back(chosen > 1 ? (2 * k * (count - 1) + chosen - 1) / (2 * (chosen - 1)) : 0);
  return frames;
}

}  // namespace blossom
