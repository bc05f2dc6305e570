#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/shape/motion.h"
#include "kernel/edit/edit_result.h"

namespace blossom::sweep {

/// The motion after one edit, see `pull` and `twist`.
EditResult edited(const Motion&, const MotionEdit&, const Progress& = Progress::none());

/// The motion with its own edits applied in order, and none left.
/// @throws Error InvalidInput naming the place of the edit ("edits[2]"), the reason and what to do, when an edit is wrong or
/// a place of it does not arrive; Cancelled.
Motion withEditsApplied(const Motion&, const Progress& = Progress::none());

/// The same, one edit after another: the motion before its first edit, after that, after the second and so on, one more than
/// it has edits. The last is withEditsApplied, bit for bit.
std::vector<Motion> afterEachEdit(const Motion&, const Progress& = Progress::none());

}  // namespace blossom::sweep
