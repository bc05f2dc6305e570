#pragma once
#include <span>

#include "core/progress.h"
#include "kernel/arrangement/cell_rows.h"

namespace blossom::morphology::arrangement {

/// Cells that lie in the sum of two shapes for certain: those that full cells of one shape cover when they are moved by
/// points of the other one's edges. What lies among them bounds nothing. The first shape may be a solid inside out, all
/// edges of which then bound it: none lies within the solid, as those of a body within a body would.
class SumCore {
 public:
  SumCore(const Features& a, const Features& b, bool insideOut, const Progress&);

  /// Whether a triangle or parallelogram certainly lies in the interior of the sum.
  [[nodiscard]] bool holds(std::span<const Grid3> corners) const;

 private:
  CellFrame frame_;
  CellRows inside_;
};

}  // namespace blossom::morphology::arrangement
