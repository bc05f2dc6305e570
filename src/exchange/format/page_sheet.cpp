#include "exchange/format/page_sheet.h"

#include <algorithm>

#include "geometry/shape/contact_sheet.h"
#include "geometry/shape/frame_times.h"

namespace blossom {

PageSheet pageSheet(const Sequence& sequence, const DrawnBox& shared, int cells) {
  PageSheet sheet;
  const std::vector<std::size_t> frames = spreadFrames(sequence.frames.size(), static_cast<std::size_t>(cells));
  const double letters = 0.07, gap = 0.1;  // of the longer side of a frame
  const double longer = std::max(shared.size().maxCoeff(), 1e-3);
  sheet.letterHeight = letters * longer;
  const Vec2 frame = shared.size().cwiseMax(Vec2(1e-3, 1e-3));
  const Vec2 cell = frame + Vec2(gap * longer, gap * longer + 1.5 * sheet.letterHeight);
  const SheetGrid grid = sheetGrid(frames.size(), cell, Vec2(4, 3));
  sheet.size = Vec2(grid.columns * cell.x(), grid.rows * cell.y());
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const Vec2 corner(grid.column(k) * cell.x(), sheet.size.y() - (grid.row(k) + 1) * cell.y());
    const Vec2 place = corner + Vec2(gap * longer / 2, gap * longer / 2);
    sheet.cells.push_back(
        {frames[k], place + Vec2(0, 1.5 * sheet.letterHeight) - shared.low, place, frameLabel(sequence, frames[k])});
  }
  return sheet;
}

}  // namespace blossom
