#pragma once
#include <utility>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "geometry/shape/toolpath.h"

namespace blossom::pocket {

struct UncutOptions {
  double floor = 0;         ///< height of the pocket's floor: what is cut there counts
  double tolerance = 0.01;  ///< mm: places that lie no farther than this from what is cut are no places of their own
};

/// A connected place of the part that the tool does not cut.
struct UncutPlace {
  double area = 0;                           ///< mm2
  double depth = 0;                          ///< mm from what is cut to about its farthest point ..
  Vec2 at = Vec2::Zero();                    ///< .. which lies here
  std::vector<std::pair<Vec2, Vec2>> hatch;  ///< rows across it, to be drawn
};

struct Uncut {
  double area = 0;                 ///< mm2 of the part seen from above that no move at the floor sweeps
  double within = 0;               ///< mm2, most that the area may be off
  double partArea = 0;             ///< mm2
  std::vector<UncutPlace> places;  ///< the largest first
  std::size_t steps = 0;           ///< curves looked at, each as often as it was
};

/// What a program leaves of a part, from its moves and the part's outline alone: the part less the union of the tool's full
/// width along every move at the floor. Nothing of how the moves were planned is asked.
///
/// The part's box is halved until few curves are in a cell; cells that one sweep hides are left out. In a cell, rows at all
/// heights where a boundary begins, ends or turns cut part and sweeps into strips whose edges are lines and arcs. In a
/// strip, intervals with the arcs' bulges added and taken away bound the area from both sides; strips are halved until the
/// two bounds are together. Cells whose curves lie in one another's way stop at a limit of work, so that the whole does.
///
/// `within` is half of what stays between the bounds, about 1e-6 of the part's area as long as no cell meets its limit, and
/// 4e-6 of it more for splines, which are taken as lines. O(n log n) for n pieces of the part's boundary (of a spline, the
/// lines) and of the sweeps as long as they lie beside one another; O(n k) where k of them lie on one another.
/// @throws Error Cancelled.
Uncut uncutOf(const Region& part, const Toolpath&, const UncutOptions&, const Progress& = Progress::none());

}  // namespace blossom::pocket
