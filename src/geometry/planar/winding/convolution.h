#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/polygons/grid.h"
#include "geometry/planar/winding/corner_numbers.h"

namespace blossom::planar {

class CertainInside;

/// A straight edge with multiplicity `count`; a negative one counts edges in the opposite direction.
struct CountedEdge {
  GridPoint from, to;
  int count = 1;
  std::uint32_t mayBound : 1 = 1;  ///< 0 when it never bounds what is inside
  std::uint32_t source : 31 = 0;   ///< place in PairSources::all; 0: unknown
};

/// Directs every edge from its lower to its higher point, adds the counts of equal edges and removes edges with count 0.
void joinEqual(std::vector<CountedEdge>&, const Progress& = Progress::none());

/// What the edges of a convolution come from: an edge of one set, moved by a corner of the other.
struct PairSources {
  struct Pair {
    std::uint32_t edge = 0, corner = 0;
    bool edgeOfFirst = true;
  };
  CornerNumbers first, second;       ///< of the two sets
  std::vector<Pair> all = {Pair()};  ///< filled by the convolution; the first one stands for unknown
};

/// The convolution of two sets. Its winding number at x is the number of components of A intersected with x - B, so it is
/// positive exactly inside A + B. An edge is paired with every vertex of the other set whose turn contains the edge's
/// direction (convex +, reflex -), parallel edges once (Guibas, Ramshaw & Stolfi 1983). Holes that the other part cannot
/// enter are removed first (Baram, Fogel, Halperin, Hemmer & Morr 2018, "fill up"), because the intersection of A and x - B
/// could otherwise have a hole, which counts -1. Edges at reflex vertices never bound. Curves, as loops there and back, turn
/// by half a turn at their ends, and a point takes all edges: where a set is a curve, the components are counted along it.
/// The result is as joinEqual returns it. O(n log n + k) for k pairs: the edges of a loop are sorted by direction once.
/// @param sources when given, edges that may bound and come from numbered edges and corners name them
/// @param inside of the sum: when given, the edges that lie there are left out, and winding numbers there are just positive
/// @throws Error LimitExceeded above three million edges; Cancelled; TooMuchWork.
std::vector<CountedEdge> convolution(std::span<const GridPolygon> a, std::span<const GridPolygon> b,
                                     const Progress& = Progress::none(), const Effort& = Effort(),
                                     PairSources* sources = nullptr, const CertainInside* inside = nullptr);

/// Number of edges of the convolution before equal ones are joined, found without making them. O((n + m) log(n + m))
double pairCount(std::span<const GridPolygon> a, std::span<const GridPolygon> b, const Progress& = Progress::none());

/// An edge of one loop at a corner of another whose turn contains the edge's direction, in their own coordinates.
struct EdgeAtCorner {
  GridPoint from, to, corner;
  bool edgeOfFirst = true;
  int sign = 1;  ///< -1 at reflex corners, where the edge counts backwards and bounds nothing
};

/// The pairs of two loops that a convolution adds up. They are those of all positive multiples of the loops, too. O(n log n
/// + k).
std::vector<EdgeAtCorner> pairsOf(const GridLoop& a, const GridLoop& b, const Progress& = Progress::none());

}  // namespace blossom::planar
