#include "geometry/planar/polygons/snapped_operands.h"

namespace blossom::planar {

SnappedOperands snappedTogether(const Polygons& a, const Polygons& b) {
  const Box2 boxA = boxOf(a), boxB = boxOf(b);
  const Grid gridA{boxA.center(), gridUnit(boxA.sizes().cwiseMax(boxB.sizes()))};
  const Grid gridB{boxB.center(), gridA.unit};
  return {snapped(a, gridA), snapped(b, gridB), gridA, gridB, {gridA.origin + gridB.origin, gridA.unit}};
}

}  // namespace blossom::planar
