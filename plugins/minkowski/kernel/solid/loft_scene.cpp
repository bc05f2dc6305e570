#include "kernel/solid/loft_scene.h"

namespace blossom::minkowski {

int LoftScene::order(int i, const PlaceOnLine& a, const PlaceOnLine& b, const LoftTime& time) const {
  if (a.end >= 0 && b.end >= 0) return predicates.ahead(i, a.facet, a.end, b.facet, b.end, time);
  if (b.end >= 0) return -order(i, b, a, time);
  const int side =
      a.end >= 0 ? predicates.side(b.facet, a.facet, a.end, time) : predicates.sideOfMeeting(i, a.facet, b.facet, time);
  return side * predicates.turn(b.facet, i);  // which grows along the line where that is positive
}

int LoftScene::windingBeyond(int i, const PlaceOnLine& place, const LoftTime& time, int slab) const {
  int winding = 0;
  const int count = static_cast<int>(loft.facets.size());
  for (int k = 0; k < count; ++k) {
    if (!counts(k, slab)) continue;
    const bool fromLeft = predicates.side(i, k, 0, time) > 0, toLeft = predicates.side(i, k, 1, time) > 0;
    if (fromLeft == toLeft) continue;
    if (order(i, {k, -1}, place, time) > 0) winding -= facet(k).count * predicates.turn(k, i);
  }
  return winding;
}

}  // namespace blossom::minkowski
