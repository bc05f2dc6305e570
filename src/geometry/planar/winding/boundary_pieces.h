#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/winding/winding_cells.h"

namespace blossom::planar {

/// A point where a boundary may turn: an end of edges, or a crossing, named by two of its edges. Equal names, equal points.
struct CornerName {
  std::int64_t first = 0, second = 0;
  bool crossing = false;
  friend bool operator==(const CornerName&, const CornerName&) = default;
};

/// A piece of an edge with the inside to its left.
struct BoundaryPiece {
  CornerName from, to;
  Vec2 fromAt, toAt;  ///< rounded
  std::uint32_t edge = 0;
  bool forward = true;  ///< in the direction of the edge
};

/// The pieces of edges with the inside of the rule on one side only, each once. Exact: what meets an edge is ordered along
/// it by fractions of integers. Runs on all cores; the order of the pieces is the same for any number.
/// @throws Error Cancelled; Internal when the edges are no cycles.
std::vector<BoundaryPiece> boundaryPieces(std::span<const CountedEdge>, const WindingCells&, WindingRule, const Progress&);

}  // namespace blossom::planar
