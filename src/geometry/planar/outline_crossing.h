#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom {

/// Where a path crosses, touches or runs back over itself; nothing when it does not. Lines, arcs and splines are cut into
/// rational Bézier pieces that cannot cross themselves; pairs whose convex hulls overlap are halved until they are as good
/// as straight (Lane & Riesenfeld 1980). What comes closer than 1e-6 mm counts as touching. Segments that follow each other
/// meet at their common end. O(n log n + pairs that overlap). Hand-written because CGAL's traits of Bézier curves take no
/// rational ones.
std::optional<Vec2> selfCrossing(const Path&, const Progress& = Progress::none());
/// Where two paths cross or touch.
std::optional<Vec2> crossing(const Path&, const Path&, const Progress& = Progress::none());
/// Where closed outlines of a drawing cross so that beside that place its fill rule fills another side than the union of the
/// region's loops does, which was made of them; nothing where they merely touch.
std::optional<Vec2> misfilledCrossing(const Curves& drawing, const Region&, const Progress& = Progress::none());

}  // namespace blossom
