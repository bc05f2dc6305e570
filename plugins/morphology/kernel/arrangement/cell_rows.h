#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/progress.h"
#include "kernel/arrangement/features.h"

namespace blossom::morphology::arrangement {

/// Cubes that fill a box: cell k of an axis reaches from `origin` + k `size` to `origin` + (k + 1) `size`.
struct CellFrame {
  Grid3 origin{};
  double size = 1;  ///< in steps of the grid
  std::array<int, 3> cells{};

  /// Whole numbers are borders of cells.
  [[nodiscard]] Eigen::Vector3d inCells(const Grid3& p) const { return inDoubles(p - origin) / size; }
};

/// More than the rounding of places in cells, of which there are at most 64 along an axis.
inline constexpr double roundingInCells = 1e-9;

/// Marked cells of a frame, at first none: rows of bits along x.
class CellRows {
 public:
  using Row = std::uint64_t;
  static constexpr int longest = 64;  ///< cells along each axis
  using Cell = std::array<int, 3>;

  CellRows() = default;
  explicit CellRows(const std::array<int, 3>& cells)
      : cells_(cells), rows_(static_cast<std::size_t>(cells[1]) * static_cast<std::size_t>(cells[2]), 0) {}

  [[nodiscard]] const std::array<int, 3>& cells() const { return cells_; }
  [[nodiscard]] Row& row(int y, int z) { return rows_[index(y, z)]; }
  [[nodiscard]] Row row(int y, int z) const { return rows_[index(y, z)]; }
  [[nodiscard]] bool at(const Cell& c) const { return (row(c[1], c[2]) >> c[0] & 1) != 0; }

  /// Of a row, the cells from `first` to `last`. @pre they are cells of a row
  static Row bits(int first, int last) { return ~Row{0} >> (longest - 1 - last + first) << first; }
  /// Marks all cells from `low` to `high` that the frame has.
  void mark(Cell low, Cell high);
  /// Marks what is marked in cells of the same frame.
  void add(const CellRows& other) {
    for (std::size_t k = 0; k < rows_.size(); ++k) rows_[k] |= other.rows_[k];
  }
  /// Whether all cells from `low` to `high` are marked; false where they leave the frame.
  [[nodiscard]] bool all(const Cell& low, const Cell& high) const;

 private:
  [[nodiscard]] std::size_t index(int y, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(cells_[1]) + static_cast<std::size_t>(y);
  }

  std::array<int, 3> cells_{};
  std::vector<Row> rows_;
};

/// The cells that a box touches, borders included.
struct TouchedCells {
  CellRows::Cell low, high;
  TouchedCells(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = static_cast<int>(std::floor(from[static_cast<Eigen::Index>(k)] - roundingInCells));
      high[k] = static_cast<int>(std::floor(to[static_cast<Eigen::Index>(k)] + roundingInCells));
    }
  }
};

/// The cells that lie wholly within a solid, or wholly outside of it when it is `insideOut`. Thin shapes have none. Small
/// groups of such cells may be left out. About O(faces + cells) and one winding number for each group.
CellRows fullCells(const Features&, bool insideOut, const CellFrame&, const Progress&);

}  // namespace blossom::morphology::arrangement
