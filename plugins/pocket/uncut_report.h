#pragma once
#include "feature/feature_type.h"
#include "geometry/shape/toolpath.h"
#include "kernel/check/coverage.h"
#include "kernel/check/uncut.h"

namespace blossom::pocket {

/// The area of the part and its shares as figures: `part_mm2`, `cut_mm2`, `unreachable_mm2`, `left_mm2` where stock is left.
/// With `residue_mm2` of the path they add up.
void reportCoverage(const Coverage&, Evaluated&);

/// Reports the uncut area: the figure `uncut_mm2`, dots over the places that tell why they are uncut, and a warning when a
/// place is larger than the rounding in a square corner. @throws Error as ToolReach.
void reportUncut(const Uncut&, const Region& part, const CoverageOptions&, double floor, Toolpath&, Evaluated&,
                 const Progress& = Progress::none());

}  // namespace blossom::pocket
