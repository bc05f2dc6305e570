#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/shape.h"

namespace blossom {

struct DrawnBox {
  Vec2 low{0, 0}, high{0, 0};
  [[nodiscard]] Vec2 size() const { return high - low; }
};

/// Bounding box of all curves of the drawings: the least one around lines and arcs, at most twice the chord wider on a side
/// than a spline. A point at the origin when there are none.
DrawnBox drawnBox(const std::vector<Curves>& drawings, double chord);
/// The box of all frames of a sequence, which is the page that they share. Frames that are no drawings have no part in it.
/// O(curves). @throws Error Cancelled.
DrawnBox drawnBox(const Sequence&, double chord, const Progress&);

}  // namespace blossom
