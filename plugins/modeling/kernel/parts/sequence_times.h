#pragma once
#include <span>
#include <vector>

#include "core/ease.h"
#include "geometry/shape/shape.h"

/// Frames of sequences in time. The frames themselves are shared, never computed. A sequence without a time for each frame
/// counts as evenly spread from 0 to 1.
namespace blossom::modeling {

/// One time for each frame.
std::vector<double> frameTimes(const Sequence&);

/// The frame nearest in time; of two the earlier one. The sequence has at least one. O(frames).
std::size_t nearestFrame(const Sequence&, double time);

struct RetimeOptions {
  bool reverse = false;  ///< before it is eased
  Ease ease = Ease::Linear;
  std::size_t frames = 0;  ///< 0: all frames stay, at times of their own; else so many at even times, each the nearest one
};

/// The sequence from its first to its last time, played another way. Where all frames have one time they count as evenly
/// spread over one unit after it. O(frames), O(frames wanted times frames) when `frames` is set.
/// @throws Error InvalidInput for one without frames.
Sequence retimed(const Sequence&, const RetimeOptions&);

struct JoinOptions {
  bool keepLengths = false;  ///< each part lasts as long as it did, in proportion; else all frames have even times
  bool mergeEnds = false;    ///< leaves out the first frame of each sequence but the first part: it is the one before it
};

/// Sequences and single shapes, which are frames, one after the other from 0 to 1. With `keepLengths` a part begins one step
/// after the one before it ends, or at its end where ends are merged; the step is the mean one of all the sequences, and 1
/// where there is none.
/// @throws Error InvalidInput when there is no frame, LimitExceeded above maximumFrames.
Sequence joinedInTime(std::span<const Shape> parts, const JoinOptions&);

}  // namespace blossom::modeling
