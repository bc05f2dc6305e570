#pragma once
#include "feature/feature_type.h"
#include "geometry/shape/toolpath.h"
#include "kernel/check/uncut.h"

namespace blossom::pocket {

/// Tells what stays uncut: the figure `uncut_mm2`, dots over the places, and a warning when a place is more than the round
/// that the tool leaves in a square corner. @param leave mm that were to stay on the walls
void reportUncut(const Uncut&, double leave, double floor, Toolpath&, Evaluated&);

}  // namespace blossom::pocket
