#pragma once
#include <cstddef>

#include "core/vector.h"

namespace blossom {

/// Equal cells in rows, from the upper left, row by row.
struct SheetGrid {
  int columns = 1, rows = 1;
  [[nodiscard]] int column(std::size_t cell) const { return static_cast<int>(cell) % columns; }
  [[nodiscard]] int row(std::size_t cell) const { return static_cast<int>(cell) / columns; }
};

/// The grid in which pictures of the size `picture` come out largest on a sheet of the proportions of `sheet`; of equally
/// good ones, that with the fewest empty cells. Both sizes are positive. O(cells).
SheetGrid sheetGrid(std::size_t cells, const Vec2& picture, const Vec2& sheet);

}  // namespace blossom
