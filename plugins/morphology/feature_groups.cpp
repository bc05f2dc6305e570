#include "feature_groups.h"

#include <algorithm>

#include "isolate/in_worker.h"

namespace blossom::morphology {

namespace {

const char* wayOf(const MorphologyStats& stats) {
  if (stats.prisms) return "prisms";
  return stats.way == Way::Nef ? "nef" : "corefined";
}

Value statsOf(const MorphologyStats& stats) {
  return {{"parts_a", stats.partsA},     {"parts_b", stats.partsB},
          {"pairs", stats.pairs},        {"candidates", stats.candidates},
          {"check_ms", stats.checkMs},   {"decompose_ms", stats.decomposeMs},
          {"sum_ms", stats.sumMs},       {"unite_ms", stats.uniteMs},
          {"output_ms", stats.outputMs}, {"way", wayOf(stats)}};
}

}  // namespace

FeatureType inWorkers(const std::function<FeatureType(Way)>& make, std::string activity) {
  return inWorker(make(Way::Corefined), {.activity = std::move(activity), .rival = make(Way::Nef).evaluate});
}

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
