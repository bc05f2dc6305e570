#pragma once
#include <functional>
#include <vector>

#include "feature/feature_type.h"

namespace blossom {

/// Whether an input takes a shape frame by frame: a sequence, unless the input is declared to take sequences as they are.
/// The feature is then evaluated once for each frame (see frame_by_frame.h). O(1).
bool takenByFrames(const InputSpec&, const Shape&);

/// Whether an input accepts a shape: its kind is one of the declared kinds or, for a region input, it is curves or faces
/// that may bound a region (arrangedInputs converts them or reports where they are open). A solid is never accepted as a
/// region. Of a sequence that is taken frame by frame, each frame must be accepted. O(1), or O(frames).
bool accepts(const InputSpec&, const Shape&);

/// Number of inputs that each input spec of a type receives when `given` ones are assigned in order: each spec is filled
/// while enough are left for those after it, and what an optional spec does not accept is left to the next. The last spec
/// receives all that are left over, also more than its maximum. O(given).
/// @param accepts whether a spec accepts one of the inputs, both by their index
std::vector<std::size_t> inputCounts(const FeatureType&, std::size_t given,
                                     const std::function<bool(std::size_t spec, std::size_t input)>& accepts);

/// Whether a shape goes into the result of the feature that it is an input of, so that the result is shown in its place. Of
/// a sequence that is taken frame by frame the first frame tells.
bool consumes(const InputSpec&, const Shape&);

/// Checks the inputs named by sub-shape parameters ("shape:edge:3"); a sub-shape without an input name belongs to the only
/// input.
/// @param parameters complete and in canonical form
/// @throws Error InvalidParameter when no input of that name is declared.
void checkNamedInputs(const FeatureType&, const Value& parameters);

}  // namespace blossom
