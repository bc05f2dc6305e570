#pragma once
#include "core/progress.h"
#include "geometry/planar/polygons/sound_region.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// The smallest convex region around a region: its corners and arcs that face outward, joined by lines that touch both. By
/// the support functions, the larger of which is known between their crossings in closed form, so lines and arcs are exact
/// to rounding; free-form parts are cubic splines within the tolerance, and lines touch them within it. No loops when the
/// region has none. O(n log n) for n segments. @throws Error Cancelled.
Region convexHull(const Region&, double tolerance, const Progress& = Progress::none());
/// The same within the tolerance of the shape; a convex shape itself.
SoundRegion convexHull(const SoundRegion&, const Progress& = Progress::none());

}  // namespace blossom::planar
