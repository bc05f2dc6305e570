#pragma once
#include <vector>

#include "feature/feature_type.h"
#include "geometry/shape/motion_edit.h"

namespace blossom::sweep {

/// What the feature types of edits share: their input, the records of their parameters, and how they are evaluated.

InputSpec motionToEdit();

/// Records {"u": .., "v": ..} of places on the surface.
ParameterSpec placeRecord();
std::vector<MotionPlace> placesOf(const std::vector<Value>& records);

/// How wide a part the edit changes, and what a user reads of it.
ParameterSpec editLevel();
inline constexpr const char* editLevelHelp =
    "How wide a part changes: 0 the spans of the motion, above it finer ones, below it coarser ones.";

/// A named field of a record.
ParameterSpec fieldOf(const char* name, ParameterSpec, const char* help);

/// The motion of the input, its own edits applied first, after one more. What does not arrive is a warning with the reason
/// and the remedy; the rest of the edit is done. Stats: `remainder` (mm or degrees), `moved_poles`, and `edits`, how many of
/// the input's own were applied. An edit without a place changes nothing, and says so.
Evaluated evaluatedEdit(const Inputs&, const MotionEdit&, const Progress&);

}  // namespace blossom::sweep
