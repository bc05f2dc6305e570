#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/numeric/box_tree.h"
#include "geometry/planar/region.h"

namespace blossom {

/// The boundary of a region in a tree of boxes, for many questions about points: O(n log n) to make. Where segments are well
/// spread a distance takes O(log n), a winding number O(log n + k) for k segments at the level of the point, to its right.
/// Immutable, safe to use from several threads.
class BoundaryTree {
 public:
  /// @throws Error Cancelled
  explicit BoundaryTree(const Region&, const Progress& = Progress::none());

  /// Of a point from the boundary; infinite where there is none. @pre no splines
  [[nodiscard]] double distanceTo(const Vec2&) const;
  /// Sum of the winding numbers of all loops, see planar.h.
  [[nodiscard]] int windingNumber(const Vec2&) const;

 private:
  std::vector<Segment> segments_;  ///< and lines that bridge the rounding between two of them
  BoxTree<2> tree_;
};

}  // namespace blossom
