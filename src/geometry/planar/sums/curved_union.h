#pragma once
#include <span>

#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/polygons/sound_region.h"

namespace blossom::planar {

/// The union of regions, which may overlap: lines and arcs stay what they are, what comes of splines is a cubic spline
/// within the tolerances. Which pieces bound it is decided by polygons as in curved_sum.h. O((n + k) log n) for k crossings.
/// @throws Error LimitExceeded, Cancelled; TooMuchWork
SoundRegion united(std::span<const SoundRegion>, const Progress&, Effort&);

}  // namespace blossom::planar
