#include "geometry/shape/contact_sheet.h"

#include <algorithm>

namespace blossom {

SheetGrid sheetGrid(std::size_t cells, const Vec2& picture, const Vec2& sheet) {
  const int count = std::max(1, static_cast<int>(cells));
  SheetGrid best;
  double largest = -1;
  for (int columns = 1; columns <= count; ++columns) {
    const SheetGrid grid{columns, (count + columns - 1) / columns};
    const double scale = std::min(sheet.x() / (grid.columns * picture.x()), sheet.y() / (grid.rows * picture.y()));
    const bool same = scale > largest * (1 - 1e-12) && scale < largest * (1 + 1e-12);
    if (same ? grid.columns * grid.rows >= best.columns * best.rows : scale < largest) continue;
    largest = scale;
    best = grid;
  }
  return best;
}

}  // namespace blossom
