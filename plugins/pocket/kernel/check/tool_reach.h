#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/planar/boundary_tree.h"
#include "geometry/shape/toolpath.h"
#include "kernel/check/coverage.h"

namespace blossom::pocket {

/// Tells of places that a tool did not cut why that is.
class ToolReach {
 public:
  /// O(n log n) for n pieces of the boundary. @throws Error as ClearanceDiagram.
  ToolReach(const Region& part, const CoverageOptions&, const Progress& = Progress::none());

  /// Of a place of the part: beyond the opening of the part by the tool, beyond that of the part less what is left on its
  /// walls, or missed: within both by more than the tolerance. O(log n)
  [[nodiscard]] MarkKind at(const Vec2&) const;

 private:
  double radius_, tolerance_;
  BoundaryTree all_;                         ///< places of the tool's centre in the part
  std::optional<BoundaryTree> leavingSome_;  ///< those that leave on the walls what was asked; empty: nothing was
};

}  // namespace blossom::pocket
