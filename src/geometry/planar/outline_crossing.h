#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom {

/// A point where a path crosses, touches or retraces itself; empty when there is none. Lines, arcs and splines are divided
/// into rational Bézier pieces that cannot cross themselves; pairs with overlapping convex hulls are halved until they are
/// nearly straight (Lane & Riesenfeld 1980). Pieces closer than 1e-6 mm count as touching, consecutive segments at their
/// common end do not. O(n log n + overlapping pairs).
std::optional<Vec2> selfCrossing(const Path&, const Progress& = Progress::none());
/// A point where two paths cross or touch.
std::optional<Vec2> crossing(const Path&, const Path&, const Progress& = Progress::none());
/// A crossing of closed outlines of a drawing next to which the fill rule of the drawing and the union of the loops of
/// `Region`, made from the drawing, disagree about inside and outside. Empty where outlines merely touch.
std::optional<Vec2> misfilledCrossing(const Curves& drawing, const Region&, const Progress& = Progress::none());

}  // namespace blossom
