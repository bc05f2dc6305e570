#pragma once
#include <vector>

#include "exchange/plain/motion_node.h"
#include "geometry/shape/motion_edit.h"

namespace blossom {

/// The list `edits` of a motion file (resources/manual/sweep.md): its form is read here, whether an edit can be reached is
/// found where it is applied. @throws Error FormatDamaged with the way to the wrong value: "edits[2].to[0]".
std::vector<MotionEdit> readEdits(const MotionNode& edits);

/// The list as readEdits reads it, every number as it is.
Value editsJson(const std::vector<MotionEdit>&);

}  // namespace blossom
