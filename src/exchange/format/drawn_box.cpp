#include "exchange/format/drawn_box.h"

#include "geometry/planar/segment_box.h"

namespace blossom {
namespace {

class GrowingBox {
 public:
  void add(const Curves& curves, double chord) {
    for (const Path& path : curves.paths)
      for (const Segment& segment : path.segments) {
        if (std::holds_alternative<Spline2>(segment))
          addSpline(segment, chord);
        else
          box_.extend(boxAround(segment));
      }
  }
  [[nodiscard]] DrawnBox box() const { return box_.isEmpty() ? DrawnBox{} : DrawnBox{box_.min(), box_.max()}; }

 private:
  /// The poles of a spline may lie far outside of it; a chain of chords lies within the chord of it.
  void addSpline(const Segment& spline, double chord) {
    for (const Vec2& p : flatten(Path{{spline}, false, {}, {}}, chord)) {
      box_.extend(Vec2(p - Vec2(chord, chord)));
      box_.extend(Vec2(p + Vec2(chord, chord)));
    }
  }

  Box2 box_;
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
