#pragma once
#include <span>

#include "geometry/planar/winding/wide_products.h"
#include "geometry/planar/winding/winding_cells.h"

namespace blossom::planar {

/// Where a walk along an edge begins with a winding number that is known: where the edge passes a border of cells or, near
/// its start, a half-integer. No corner of the arrangement of the edges lies on such a line.
struct Anchor {
  bool vertical = false;    ///< the line is x = value, else y = value
  std::int64_t twice = 0;   ///< twice the coordinate, an odd number
  int column = 0, row = 0;  ///< of the corner of a cell whose winding number is known
  Fraction t;               ///< the share of the edge, exact
};

/// The anchors of an edge, and the winding numbers there.
class AnchoredEdge {
 public:
  using Cell = WindingCells::Cell;

  AnchoredEdge(std::span<const CountedEdge> edges, const WindingCells& cells, std::uint32_t number)
      : edges_(edges), cells_(cells), number_(number), edge_(edges[number]), by_(edge_.to - edge_.from) {}

  /// Half a unit after the start, in the cell of the start because the edge runs no steeper than that.
  [[nodiscard]] Anchor atStart(const Cell& first) const;
  /// On the border between neighbours.
  [[nodiscard]] Anchor between(const Cell& from, const Cell& to) const;
  /// The winding number just after the anchor, to the left: from the known corner along a border, then straight to the edge.
  /// @param cell      the first that the edge runs through after the anchor
  /// @param covering  how often edges lie on this one there, itself counted
  [[nodiscard]] int windingToLeft(const Anchor&, const Cell& cell, int covering) const;

 private:
  [[nodiscard]] Anchor at(bool vertical, std::int64_t twice, const Cell& corner) const;
  [[nodiscard]] int passedGoingUp(const CountedEdge&, const Anchor&) const;
  [[nodiscard]] int passedGoingRight(const CountedEdge&, const Anchor&) const;
  [[nodiscard]] Fraction heightOf(const CountedEdge&, std::int64_t twiceX) const;
  [[nodiscard]] Fraction reachOf(const CountedEdge&, std::int64_t twiceY) const;

  std::span<const CountedEdge> edges_;
  const WindingCells& cells_;
  std::uint32_t number_;
  const CountedEdge& edge_;
  GridPoint by_;
};

}  // namespace blossom::planar
