#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/polygons.h"
#include "kernel/winding/boundary_pieces.h"

namespace blossom::minkowski {

/// Joins pieces to rings that visit every corner once, and these to parts: outer rings counter-clockwise with the holes in
/// them. Holes that lie in no part are left out, and so are rings narrower than the rounding of their corners, at most an
/// eighth of a unit. O(n log n) for well-distributed pieces.
/// @throws Error Cancelled; Internal when the pieces do not close.
Polygons joinedPieces(std::span<const BoundaryPiece>, std::span<const CountedEdge>, const Progress&);

}  // namespace blossom::minkowski
