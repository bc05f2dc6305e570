#pragma once
#include <string>
#include <vector>

#include "exchange/format/drawn_box.h"

namespace blossom {

/// Frames of a sequence beside each other on one page, in true size: each in a cell as large as the page that all frames
/// share, its time below it. Coordinates have y upwards, like drawings.
struct PageSheet {
  struct Cell {
    std::size_t frame = 0;
    Vec2 shift{0, 0};  ///< mm, from the place of the frame to that on the sheet
    Vec2 label{0, 0};  ///< lower left of its text on the sheet
    std::string text;
  };
  std::vector<Cell> cells;
  Vec2 size{0, 0};          ///< of the sheet, whose lower left is the origin
  double letterHeight = 1;  ///< mm
};

/// @param shared the box of all frames  @param cells how many there may be, above 0
PageSheet pageSheet(const Sequence&, const DrawnBox& shared, int cells);

}  // namespace blossom
