#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/boundary_tree.h"
#include "geometry/planar/region.h"

/// Which sides of loops are inside, by winding numbers.
namespace blossom::planar {

/// Loops that cross nowhere and share no sides, those around areas and those around holes turning opposite ways.
class LoopSenses {
 public:
  /// O(n log n) for n segments. @throws Error Cancelled
  LoopSenses(const std::vector<Path>& loops, const Progress&);

  /// Whether a place off all loops is inside: enclosed once. As BoundaryTree::windingNumber.
  [[nodiscard]] bool holds(const Vec2& place) const;
  /// Whether one of the loops has the inside on one side and the outside on the other one. The same, and O(n log n) for the
  /// n segments of that loop.
  [[nodiscard]] bool bounds(const Path& loop) const;

 private:
  BoundaryTree all_;
  int inward_ = 1;  ///< the winding number of what is inside
};

}  // namespace blossom::planar
