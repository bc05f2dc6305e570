#pragma once
#include <functional>
#include <vector>

#include "core/progress.h"
#include "kernel/arrangement/points.h"

namespace blossom::morphology::arrangement {

/// A convex polygon of the arrangement, without others in its interior.
struct Tile {
  int plane = 0;
  bool sameWay = true;       ///< outward is where the normal of the plane points to
  int patch = 0;             ///< tiles of one patch lie to the outside in the same way; patch 0 has none
  std::vector<int> corners;  ///< points, counter-clockwise in the drawing of the plane
  std::vector<bool> isCut;   ///< whether the edge from corner k on belongs to the border of the patch
};

struct SumSpace {
  std::function<bool(const Grid3&)> holds;  ///< whether a place off all tiles belongs to the sum
  bool isBounded = true;
};

/// Which patches bound the sum. The sum lies behind all of them, so the space before a patch is one of the cells of the
/// arrangement, and before all patches of a cell there is the same: neighbours around edges find them, rays the shells of a
/// cell that meet nowhere. What a ray leaves without meeting anything is outside of a bounded sum; only about other cells
/// the sum is asked. O(n log n) and one ray for each shell. @throws Error Cancelled.
std::vector<bool> boundingPatches(const std::vector<Tile>&, std::size_t patches, const Planes&, Points&, const SumSpace&,
                                  const Progress&);

}  // namespace blossom::morphology::arrangement
