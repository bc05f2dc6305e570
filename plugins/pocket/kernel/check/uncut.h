#pragma once
#include <utility>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "geometry/shape/toolpath.h"

namespace blossom::pocket {

struct UncutOptions {
  double floor = 0;         ///< height of the pocket's floor; cuts there count
  double tolerance = 0.01;  ///< mm: places that reach no farther than this from the cut area are not listed
};

/// A connected area of the part that the tool does not cut.
struct UncutPlace {
  double area = 0;                           ///< mm2
  double depth = 0;                          ///< mm, approximate maximum distance of its points from the cut area ..
  Vec2 at = Vec2::Zero();                    ///< .. and the point at that distance
  std::vector<std::pair<Vec2, Vec2>> hatch;  ///< rows across it, for drawing
};

struct Uncut {
  double area = 0;                 ///< mm2 of the part, seen from above, that no move at the floor sweeps
  double within = 0;               ///< mm2, error bound of the area
  double partArea = 0;             ///< mm2
  std::vector<UncutPlace> places;  ///< the largest first
  std::size_t steps = 0;           ///< number of curves processed, with repetitions
};

/// The area that a program leaves of a part: the part minus the union of the tool's full width along every move at the
/// floor. Uses only the moves and the outline of the part, nothing of the planning of the moves.
///
/// The box of the part is halved until each cell contains few curves; cells covered by a single sweep are dropped. In a
/// cell, rows at all heights where a boundary begins, ends or turns divide part and sweeps into strips whose edges are lines
/// and arcs. In a strip, intervals with the bulges of the arcs added and subtracted bound the area from both sides; strips
/// are halved until the two bounds are close. The work per cell is limited, for cells where curves overlap each other.
///
/// `within` is half of the difference of the bounds, about 1e-6 of the part's area as long as no cell reaches its limit, and
/// 4e-6 of it more for splines, which are replaced by lines. O(n log n) for n pieces of the part's boundary (of a spline,
/// the lines) and of the sweeps when they lie beside one another; O(n k) when k of them overlap.
/// @throws Error Cancelled.
Uncut uncutOf(const Region& part, const Toolpath&, const UncutOptions&, const Progress& = Progress::none());

}  // namespace blossom::pocket
