#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/effort.h"
#include "kernel/grid.h"

namespace blossom::minkowski {

/// A straight edge that counts `count` times (below 0: run through backwards).
struct CountedEdge {
  GridPoint from, to;
  int count = 1;
};

/// Every edge from its lower to its higher point, equal ones in one, those that cancel left out.
void joinEqual(std::vector<CountedEdge>&);

/// The same winding numbers from edges that lie over one another nowhere: those of one line are cut at each other's ends
/// and joined. Exact. @pre as joinEqual leaves them
void joinOverlapping(std::vector<CountedEdge>&);

/// The convolution of two sets: its winding number at x is the number of components of A meeting x - B, above 0 exactly
/// inside of A + B. An edge is paired with every vertex of the other set whose turn passes through its direction (convex
/// +, reflex -), parallel edges once (Guibas, Ramshaw & Stolfi 1983). Holes that the other part cannot get into are left
/// out first (Baram, Fogel, Halperin, Hemmer & Morr 2018, "fill up"): else A meeting x - B could have a hole, which would
/// count -1. Equal edges are joined, those that cancel left out; every edge runs from the lower to the higher point.
/// O(n log n + k) for k pairs: the edges of a loop are sorted by direction once.
/// @throws Error LimitExceeded when there would be more than three million edges; Cancelled; TooMuchWork.
std::vector<CountedEdge> convolution(std::span<const GridPolygon> a, std::span<const GridPolygon> b,
                                     const Progress& = Progress::none(), const Effort& = Effort());

}  // namespace blossom::minkowski
