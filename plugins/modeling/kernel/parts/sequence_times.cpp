#include "kernel/parts/sequence_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace blossom::modeling {
namespace {

std::vector<double> evenTimes(std::size_t count) {
  std::vector<double> times(count, 0);
  for (std::size_t k = 1; k < count; ++k) times[k] = static_cast<double>(k) / static_cast<double>(count - 1);
  return times;
}

void refuseWithoutFrames(const Sequence& sequence) {
  if (sequence.frames.empty())
    throw Error(ErrorCode::InvalidInput, "The sequence has no frames.", "Mend the feature that it comes from.");
}

/// First nearest of values that never fall.
std::size_t nearestOf(const std::vector<double>& values, double wanted) {
  const auto above = std::lower_bound(values.begin(), values.end(), wanted);
  if (above == values.begin()) return 0;
  const double below = *std::prev(above);
  const bool nearerBelow = above == values.end() || wanted - below <= *above - wanted;
  const auto found = nearerBelow ? std::lower_bound(values.begin(), above, below) : above;
  return static_cast<std::size_t>(found - values.begin());
}

/// Frames with the share of the way at which each stands.
struct Run {
  double start = 0, span = 1;
  std::vector<double> ways;
};

Run runOf(const Sequence& sequence) {
  const std::vector<double> times = frameTimes(sequence);
  Run run{times.front(), times.back() - times.front(), evenTimes(times.size())};
  if (run.span > 0)
    for (std::size_t k = 0; k < times.size(); ++k) run.ways[k] = (times[k] - run.start) / run.span;
  else
    run.span = 1;
  return run;
}

void reverse(Sequence& sequence, Run& run) {
  std::reverse(sequence.frames.begin(), sequence.frames.end());
  std::reverse(run.ways.begin(), run.ways.end());
  for (double& way : run.ways) way = 1 - way;
}

/// A part of a joined sequence: its frames, and where each is after its begin.
struct Part {
  std::vector<Shape> frames;
  std::vector<double> after;
  bool merged = false;  ///< it begins where the part before it ends
};

Part partOf(const Shape& shape, bool mayMerge) {
  const auto* sequence = shape.get<Sequence>();
  if (!sequence) return {{shape}, {0}};
  Part part{sequence->frames, frameTimes(*sequence), mayMerge && sequence->frames.size() > 1};
  const double start = part.after.empty() ? 0 : part.after.front();
  for (double& time : part.after) time -= start;
  return part;
}

double meanStep(const std::vector<Part>& parts) {
  double length = 0, steps = 0;
  for (const Part& part : parts) {
    if (part.frames.size() < 2) continue;
    length += part.after.back();
    steps += static_cast<double>(part.frames.size() - 1);
  }
  return length > 0 ? length / steps : 1;
}

/// Appends a part that begins `step` after the last frame.
void append(Sequence& all, const Part& part, double step) {
  const double end = all.times.empty() ? 0 : all.times.back();
  const double begin = all.times.empty() || part.merged ? end : end + step;
  for (std::size_t k = part.merged ? 1 : 0; k < part.frames.size(); ++k) {
    all.frames.push_back(part.frames[k]);
    all.times.push_back(begin + part.after[k]);
  }
}

}  // namespace

std::vector<double> frameTimes(const Sequence& sequence) {
  return sequence.times.size() == sequence.frames.size() ? sequence.times : evenTimes(sequence.frames.size());
}

std::size_t nearestFrame(const Sequence& sequence, double time) {
  refuseWithoutFrames(sequence);
  return nearestOf(frameTimes(sequence), time);
}

Sequence retimed(const Sequence& sequence, const RetimeOptions& options) {
  refuseWithoutFrames(sequence);
  Sequence played = sequence;
  Run run = runOf(sequence);
  if (options.reverse) reverse(played, run);
  if (options.frames == 0) {
    played.times.clear();
    for (const double way : run.ways) played.times.push_back(run.start + run.span * easedTime(options.ease, way));
    return played;
  }
  Sequence resampled;
  for (const double time : evenTimes(options.frames)) {
    resampled.frames.push_back(played.frames[nearestOf(run.ways, easedWay(options.ease, time))]);
    resampled.times.push_back(run.start + run.span * time);
  }
  return resampled;
}

Sequence joinedInTime(std::span<const Shape> shapes, const JoinOptions& options) {
  std::vector<Part> parts;
  parts.reserve(shapes.size());
  for (const Shape& shape : shapes) parts.push_back(partOf(shape, options.mergeEnds && !parts.empty()));
  Sequence all;
  const double step = meanStep(parts);
  for (const Part& part : parts) append(all, part, step);
  refuseWithoutFrames(all);
  if (all.frames.size() > maximumFrames)
    throw Error(
        ErrorCode::LimitExceeded,
        fmt::format("Joined, the sequence would have {} frames; at most {} are possible.", all.frames.size(), maximumFrames),
        "Join fewer or shorter sequences.");
  const double end = all.times.back();
  if (!options.keepLengths || !(end > 0))
    all.times = evenTimes(all.frames.size());
  else
    for (double& time : all.times) time /= end;
  return all;
}

}  // namespace blossom::modeling
