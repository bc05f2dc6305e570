#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace blossom::planar {

/// The borders of a grid's cells along one axis. They lie at half-integers, so that no point of the integer grid lies on
/// one.
class CellBorders {
 public:
  /// Cells of one size from half a unit below `low` to beyond `high`.
  CellBorders(std::int64_t low, std::int64_t high, std::int64_t size);
  /// Halves the cells that hold far more of the places than others do, down to `smallest`; at most three times as many
  /// cells.
  void refine(std::span<const std::int64_t> places, std::int64_t smallest);

  [[nodiscard]] int cells() const { return static_cast<int>(at_.size()) - 1; }
  /// Twice the coordinate of a border, an odd number.
  [[nodiscard]] std::int64_t twice(int border) const { return twiceLow_ + 2 * static_cast<std::int64_t>(at(border)); }
  /// A coordinate from the first border on; exact for points of the grid.
  [[nodiscard]] double fromFirst(std::int64_t place) const { return static_cast<double>(2 * place - twiceLow_) / 2; }
  [[nodiscard]] double at(int border) const { return at_[static_cast<std::size_t>(border)]; }
  /// The cell that holds a coordinate from the first border on; the first or the last for what lies outside.
  [[nodiscard]] int cellAt(double place) const {
    const double bucket = std::clamp(place * bucketsPerUnit_, 0.0, static_cast<double>(firstOf_.size() - 1));
    auto cell = static_cast<std::size_t>(firstOf_[static_cast<std::size_t>(bucket)]);
    while (cell + 2 < at_.size() && at_[cell + 1] <= place) ++cell;
    while (cell > 0 && at_[cell] > place) --cell;
    return static_cast<int>(cell);
  }

 private:
  void index();

  std::int64_t twiceLow_;
  std::vector<double> at_;  ///< integers, ascending from 0
  double bucketsPerUnit_ = 1;
  std::vector<int> firstOf_;  ///< the cell at the start of each of equal parts of the whole, for quick finding
};

}  // namespace blossom::planar
