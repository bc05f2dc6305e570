#include "exchange/format/drawn_box.h"

namespace blossom {
namespace {

class GrowingBox {
 public:
  void add(const Curves& curves, double chord) {
    for (const Path& path : curves.paths)
      for (const Vec2& p : flatten(path, chord)) {
        box_.low = first_ ? p : Vec2(box_.low.cwiseMin(p));
        box_.high = first_ ? p : Vec2(box_.high.cwiseMax(p));
        first_ = false;
      }
  }
  [[nodiscard]] const DrawnBox& box() const { return box_; }

 private:
  DrawnBox box_;
  bool first_ = true;
};

}  // namespace

DrawnBox drawnBox(const std::vector<Curves>& drawings, double chord) {
  GrowingBox all;
  for (const Curves& curves : drawings) all.add(curves, chord);
  return all.box();
}

DrawnBox drawnBox(const Sequence& sequence, double chord, const Progress& progress) {
  GrowingBox all;
  for (const Shape& frame : sequence.frames) {
    progress.check();
    if (const auto drawing = drawingOf(frame)) all.add(*drawing, chord);
  }
  return all.box();
}

}  // namespace blossom
