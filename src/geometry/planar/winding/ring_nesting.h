#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/winding/boundary_pieces.h"

namespace blossom::planar {

/// A closed chain of pieces that visits every corner once, with the inside to its left.
struct Ring {
  std::vector<std::size_t> pieces;
  double area = 0;  ///< to its left: positive around a part, negative around a hole
};

constexpr std::size_t noRing = ~std::size_t(0);

/// For every ring around a hole the number of the ring around the part that it is a hole of; noRing for the others, for
/// holes in no part, and for holes smaller than a unit both ways. Exact: beside the lowest point of a hole on a line through
/// it the part is the smallest whose ring has an odd number of sides below. O(n log n) for well-distributed pieces.
/// @pre rings do not cross; they may touch in corners. @throws Error Cancelled
std::vector<std::size_t> partsAround(std::span<const Ring>, std::span<const BoundaryPiece>, std::span<const CountedEdge>,
                                     const Progress&);

}  // namespace blossom::planar
