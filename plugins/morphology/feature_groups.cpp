#include "feature_groups.h"

#include <algorithm>

namespace blossom::morphology {

namespace {

const char* wayOf(const MorphologyStats& stats) {
  switch (stats.way) {
    case Way::Prisms:
      return "prisms";
    case Way::Hulls:
      return "hulls";
    case Way::Planes:
      return "planes";
    case Way::Arranged:
      break;
  }
  return "arranged";
}

Value statsOf(const MorphologyStats& stats) {
  return {{"candidates", stats.candidates}, {"check_ms", stats.checkMs},   {"sum_ms", stats.sumMs},
          {"unite_ms", stats.uniteMs},      {"output_ms", stats.outputMs}, {"way", wayOf(stats)}};
}

}  // namespace

Evaluated evaluatedFrom(MorphologyResult result, const std::vector<double>& times) {
  Evaluated out;
  out.stats = statsOf(result.stats);
  out.warnings = std::move(result.warnings);
  if (times.empty()) {
    out.shape = std::move(result.solids.front());
    return out;
  }
  Sequence sequence;
  for (Mesh& solid : result.solids) {
    sequence.times.push_back(times.at(sequence.frames.size()));
    sequence.frames.emplace_back(std::move(solid));
  }
  out.shape = std::move(sequence);
  return out;
}

std::vector<double> frameTimes(int frames) {
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(std::max(0, frames)));
  for (int k = 0; k < frames; ++k) times.push_back(frames == 1 ? 1 : static_cast<double>(k) / (frames - 1));
  return times;
}

}  // namespace blossom::morphology
