#pragma once
#include "feature/feature_type.h"
#include "geometry/shape/motion_edit.h"
#include "parameter/value.h"

namespace blossom::sweep {

/// The parameters of sweep.pull and sweep.twist, as edits and back.

/// @param parameters complete, canonical
MotionPull pullOf(const Value& parameters);
MotionTwist twistOf(const Value& parameters);

/// Everything that one drag decides; pins and the axis of a pull are left out.
Value parametersOf(const MotionPull&);
Value parametersOf(const MotionTwist&);
Value pinsOf(const MotionEdit&);  ///< the parameter `pins` of both

/// The feature that makes an edit: its type and all that is not default there.
TakenApart::Step stepOf(const MotionEdit&);

}  // namespace blossom::sweep
