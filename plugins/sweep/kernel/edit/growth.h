#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// One step on the way of a motion that grows.
struct GrowthStep {
  Motion from, to;
  std::optional<MotionEdit> edit = {};  ///< by which `to` came out of `from`, where that is known
};

/// The steps of a motion that grows: its own edits, one after another, then to each of the motions that follow, whose own
/// edits are applied first. @throws Error InvalidInput when nothing grows, or a motion does not go on from the one before:
/// degrees, knots, closure and point must be the same; as withEditsApplied.
std::vector<GrowthStep> growthSteps(const Motion& first, std::span<const Motion> following,
                                    const Progress& = Progress::none());

/// The motion after a share of a step, from 0 to 1; at these two it is `from` and `to`, bit for bit.
///
/// An edit that is known is carried out by that share: the targets of a pull lie on the straight ways from the places to
/// their own targets, a twist turns by that share of its angle. A place that cannot be reached on the way, such as one whose
/// way leads through the trajectory, comes as near as it can. Without an edit the poles of all three factors go straight
/// from one motion to the other, which is the same for pulls that only translate or scale, and otherwise turns about the
/// same axes, only not evenly. Complexity and errors as of the edit.
Motion grown(const GrowthStep&, double share, const Progress& = Progress::none());

/// Where on the way something is: a step, and the share of it that is done.
struct GrowthPlace {
  std::size_t step = 0;
  double share = 0;
  friend bool operator==(const GrowthPlace&, const GrowthPlace&) = default;
};

/// At t from 0 to 1 of the way, all steps taking equally long. @param steps at least 1
GrowthPlace growthPlace(double t, std::size_t steps);
/// Of frame `frame` of `frames` at equal times from 0 to 1: without rounding, so that a step ends exactly where a frame
/// falls on its end. @param frames at least 2
GrowthPlace growthPlace(std::size_t frame, std::size_t frames, std::size_t steps);

}  // namespace blossom::sweep
