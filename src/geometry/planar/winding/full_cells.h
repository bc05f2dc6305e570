#pragma once
#include <span>

#include "geometry/planar/polygons/grid.h"
#include "geometry/planar/winding/bit_raster.h"

namespace blossom::planar {

/// Square cells of 2^shift units, of which the first has its lower left corner at `low`.
struct CellFrame {
  GridPoint low;
  int shift = 0;
  [[nodiscard]] int column(std::int64_t x) const { return static_cast<int>((x - low.x) >> shift); }
  [[nodiscard]] int row(std::int64_t y) const { return static_cast<int>((y - low.y) >> shift); }
};

/// The cells that lie wholly inside a set and more than two units from its boundary. O(n + cells + s log s) for
/// s rows and columns that sides pass.
/// @pre all corners lie within the columns and rows of the raster
BitRaster fullCells(std::span<const GridPolygon>, const CellFrame&, int columns, int rows);

/// A cell that contains a point of a boundary, give or take a unit.
struct BoundaryCell {
  int row, column;
  friend auto operator<=>(const BoundaryCell&, const BoundaryCell&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Cells along all loops, sorted by rows, each once: those of the corners, and of points between them that are at most so
/// many cells apart.
std::vector<BoundaryCell> boundaryCells(std::span<const GridPolygon>, const CellFrame&, double spacing = 1);

}  // namespace blossom::planar
