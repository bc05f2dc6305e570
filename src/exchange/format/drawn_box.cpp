#include "exchange/format/drawn_box.h"

namespace blossom {

DrawnBox drawnBox(const std::vector<Curves>& drawings, double chord) {
  DrawnBox box;
  bool first = true;
  for (const Curves& curves : drawings)
    for (const Path& path : curves.paths)
      for (const Vec2& p : flatten(path, chord)) {
        box.low = first ? p : Vec2(box.low.cwiseMin(p));
        box.high = first ? p : Vec2(box.high.cwiseMax(p));
        first = false;
      }
  return box;
}

}  // namespace blossom
