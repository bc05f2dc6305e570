#pragma once
#include <vector>

#include "geometry/shape/motion_edit.h"
#include "parameter/value.h"

namespace blossom {

/// Edits of motions as JSON.
Value motionEditsValue(const std::vector<MotionEdit>&);
std::vector<MotionEdit> toMotionEdits(const Value&);

}  // namespace blossom
