#pragma once
#include <vector>

#include "kernel/medial/diagram.h"
#include "kernel/offset/clearance_diagram.h"

namespace blossom::pocket {

/// The part of an offset in one Voronoi cell: parallel to its piece, or around its point. Directed like the boundary.
struct TracedPiece {
  Site site;
  Vec2 from, to;
};
using TracedLoop = std::vector<TracedPiece>;

/// The closed lines of clearance d on one side: crossings of the Voronoi edges by the half-open rule (a part whose ends both
/// have clearance d is not crossed), linked within cells and from twin to twin. Where parts have clearance d at both ends
/// within `slack`, the lines of the largest of these clearances are traced instead. O(number of edges).
std::vector<TracedLoop> traced(const Diagram&, double d, double slack, Side, const Progress&);

}  // namespace blossom::pocket
