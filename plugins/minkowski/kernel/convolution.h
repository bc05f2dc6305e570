#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/effort.h"
#include "kernel/grid.h"

namespace blossom::minkowski {

/// A straight edge with multiplicity `count`; a negative one counts edges in the opposite direction.
struct CountedEdge {
  GridPoint from, to;
  int count = 1;
  bool mayBound = true;  ///< false when it never bounds what is inside
};

/// Directs every edge from its lower to its higher point, adds the counts of equal edges and removes edges with count 0.
void joinEqual(std::vector<CountedEdge>&, const Progress& = Progress::none());

/// The convolution of two sets. Its winding number at x is the number of components of A intersected with x - B, so it is
/// positive exactly inside A + B. An edge is paired with every vertex of the other set whose turn contains the edge's
/// direction (convex +, reflex -), parallel edges once (Guibas, Ramshaw & Stolfi 1983). Holes that the other part cannot
/// enter are removed first (Baram, Fogel, Halperin, Hemmer & Morr 2018, "fill up"), because the intersection of A and x - B
/// could otherwise have a hole, which counts -1. Edges at reflex vertices never bound. The result is as joinEqual returns
/// it. O(n log n + k) for k pairs: the edges of a loop are sorted by direction once.
/// @throws Error LimitExceeded above three million edges; Cancelled; TooMuchWork.
std::vector<CountedEdge> convolution(std::span<const GridPolygon> a, std::span<const GridPolygon> b,
                                     const Progress& = Progress::none(), const Effort& = Effort());

}  // namespace blossom::minkowski
