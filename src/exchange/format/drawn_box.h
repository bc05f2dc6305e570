#pragma once
#include <vector>

#include "geometry/planar/planar.h"

namespace blossom {

struct DrawnBox {
  Vec2 low{0, 0}, high{0, 0};
};

/// Bounding box of all curves of the drawings, up to the chord; a point at the origin when there are none.
DrawnBox drawnBox(const std::vector<Curves>& drawings, double chord);

}  // namespace blossom
