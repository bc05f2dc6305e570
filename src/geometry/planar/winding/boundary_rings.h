#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/polygons.h"
#include "geometry/planar/winding/boundary_pieces.h"

namespace blossom::planar {

/// A ring of corners, and for each the edge on which the boundary goes on to the next one.
struct TracedLoop {
  Loop corners;
  std::vector<std::uint32_t> edges;
};

/// A connected part in grid coordinates: outer loop counter-clockwise, holes clockwise.
struct TracedPart {
  TracedLoop outer;
  std::vector<TracedLoop> holes;
};

/// Joins pieces to rings that visit every corner once, and these to parts: outer rings counter-clockwise with the holes in
/// them. Holes that lie in no part are left out, and so are rings narrower than the rounding of their corners, at most an
/// eighth of a unit. O(n log n) for well-distributed pieces.
/// @throws Error Cancelled; Internal when the pieces do not close.
std::vector<TracedPart> joinedPieces(std::span<const BoundaryPiece>, std::span<const CountedEdge>, const Progress&);

}  // namespace blossom::planar
