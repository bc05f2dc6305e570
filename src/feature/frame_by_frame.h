#pragma once
#include "core/error.h"
#include "feature/feature_type.h"

/// Sequences are shapes: a feature that takes no sequences as they are takes one frame by frame, and its result is the
/// sequence of its results. Several sequences go together, first frame with first frame; a plain shape beside them is the
/// same in every frame.
namespace blossom {

/// The first of the sequences that are taken frame by frame; nullptr: there is none. The result has its times.
const Sequence* sequenceTakenByFrames(const FeatureType&, const Inputs&);

/// @throws Error InvalidInput when the sequences have different numbers of frames, LimitExceeded for more than
/// maximumFrames.
void checkFrames(const FeatureType&, const Inputs&);

/// The feature evaluated: once, or once for each frame of the sequences that its inputs take frame by frame, one after the
/// other. Every result of a frame is checked as checkResult and refuseInfiniteFigures do. Warnings, statistics and figures
/// are those of the frames together (see frame_summary.h).
/// @throws Error of the evaluation, in a sequence with its place: "Frame 7 (t = 0.25): .."; InvalidInput when a sequence of
/// sequences would result.
Evaluated evaluatedFeature(const FeatureType&, const Value& parameters, const Inputs&, const Progress&);

/// "Frame 7 (t = 0.25)"
std::string frameName(const Sequence&, std::size_t frame);

/// Errors with the name of the frame in front.
[[noreturn]] void throwInFrame(const Sequence&, std::size_t frame, const Error&);

/// What `work` returns; its errors, but Cancelled, get the name of the frame in front.
template <class Work>
auto inFrame(const Sequence& sequence, std::size_t frame, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throwInFrame(sequence, frame, error);
  }
}

}  // namespace blossom
