#pragma once
#include <vector>

#include "geometry/shape/motion.h"
#include "kernel/grid/grid_range.h"

namespace blossom::sweep {

/// The poles in which two motions of one form differ. A range covers all changed poles of its row, and those between them.
struct ChangedPoles {
  std::vector<GridRange> orientation, scaling;  ///< one range of columns for each row of poles
  GridRange trajectory;
};

/// Same degrees, knots, closure and point: only poles may differ.
bool haveSameForm(const Motion&, const Motion&);

/// Of two motions of the same form. Rows of a closed motion that repeat the first ones are found like any others. O(poles).
ChangedPoles changedPoles(const Motion& before, const Motion& after);

}  // namespace blossom::sweep
