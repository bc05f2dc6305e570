#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/winding/cell_borders.h"
#include "geometry/planar/winding/convolution.h"

namespace blossom::planar {

/// Winding numbers that are inside: those below `low` or above `high`.
struct WindingRule {
  int low, high;
  [[nodiscard]] bool inside(int winding) const { return winding < low || winding > high; }
};

/// A grid over edges, with equal cells where the edges are spread evenly and more of them where they crowd. The winding
/// number at one corner of each cell comes exactly from sums along columns; a cell whose edges cannot change whether it is
/// inside is certified and left out, the others list the edges that come near them. Borders lie at half-integers, so no end
/// of an edge lies on one. Filled on all cores, with the same result for any number of them.
/// @pre edges as joinEqual returns them: from the lower to the higher point.
class WindingCells {
 public:
  struct Cell {
    int column, row;
  };

  WindingCells(std::span<const CountedEdge>, WindingRule, const Progress&);

  /// Twice the coordinate of a border, an odd number.
  [[nodiscard]] std::int64_t borderX(int column) const { return columns_.twice(column); }
  [[nodiscard]] std::int64_t borderY(int row) const { return rows_.twice(row); }
  [[nodiscard]] Cell cellOf(const GridPoint& p) const {
    return {columns_.cellAt(columns_.fromFirst(p.x)), rows_.cellAt(rows_.fromFirst(p.y))};
  }

  /// Winding number just below the corner of the borders `column` and `row`.
  [[nodiscard]] int windingBelow(int column, int row) const { return corners_[cornerIndex(column, row)]; }
  /// Whether no boundary passes within a unit of the cell.
  [[nodiscard]] bool certified(const Cell& cell) const { return firsts_[index(cell)] == firsts_[index(cell) + 1]; }
  /// The edges within a unit of a cell that is not certified.
  [[nodiscard]] std::span<const std::uint32_t> edgesNear(const Cell& cell) const {
    return {lists_.data() + firsts_[index(cell)], lists_.data() + firsts_[index(cell) + 1]};
  }
  /// Pairs of edges that share a cell: about the work of finding the boundary.
  [[nodiscard]] double pairs() const;
  /// The row in which an edge crosses the border of a column, exactly; where it does so in a corner, the upper one.
  [[nodiscard]] int rowAt(const CountedEdge&, int border) const;

  /// Calls visit(cell) for all cells that an edge passes, in its order.
  template <class Visit>
  void forEachCell(const CountedEdge& edge, Visit visit) const {
    const Cell first = cellOf(edge.from), last = cellOf(edge.to);
    int row = first.row;
    for (int column = first.column; column <= last.column; ++column) {
      const int end = column == last.column ? last.row : rowAt(edge, column + 1);
      const int step = end >= row ? 1 : -1;
      for (;; row += step) {
        visit(Cell{column, row});
        if (row == end) break;
      }
    }
  }

 private:
  [[nodiscard]] std::size_t index(const Cell& c) const {
    return static_cast<std::size_t>(c.column) * static_cast<std::size_t>(rows_.cells()) + static_cast<std::size_t>(c.row);
  }
  [[nodiscard]] std::size_t cornerIndex(int column, int row) const {
    return static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_.cells() + 1) + static_cast<std::size_t>(row);
  }
  /// Columns from `first` to `last`.
  struct Columns {
    int first, last;
  };
  [[nodiscard]] Columns columnsNear(const CountedEdge&) const;
  template <class Visit>
  void forEachCellNear(const CountedEdge&, const Columns& of, const Columns& within, Visit) const;
  void layOut(std::span<const CountedEdge>);
  void windCorners(std::span<const CountedEdge>, std::span<const Columns> near, const Progress&);
  void listEdges(std::span<const CountedEdge>, std::span<const Columns> near, WindingRule, const Progress&);
  void certify(const Columns&, WindingRule, std::span<const std::int64_t> changes);
  /// Calls fill(columns) for disjoint ranges that cover [0, count), on all cores.
  template <class Fill>
  static void forEachShare(int count, std::size_t edges, const Progress&, Fill fill);

  CellBorders columns_{0, 0, 1}, rows_{0, 0, 1};
  std::vector<int> corners_;
  std::vector<std::uint32_t> firsts_, lists_;
};

}  // namespace blossom::planar
