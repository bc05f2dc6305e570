#pragma once
#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// Whether two segments of a region cross inside of both, farther than `touching` from their ends; of splines lines within
/// `chord` mm of them. Curves that touch do not cross. By the closed forms of their meetings; O(n log n) for
/// well-distributed segments.
bool segmentsCross(const Region&, double touching, double chord, const Progress& = Progress::none());

}  // namespace blossom::planar
