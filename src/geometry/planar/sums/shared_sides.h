#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// The region without the curves that two of its loops run along in opposite senses, as parts do that lie against each
/// other: both sides of such a curve are inside. Loops are cut where the other one begins and ends, and joined there. Lines
/// in common go with them; where only lines are, and where loops meet in another way, nothing is done. O(n log n + k) for n
/// segments of which k pairs are near.
/// @returns nothing where no curve is shared. @throws Error Cancelled
std::optional<Region> withoutSharedCurves(const Region&, const Progress&);

}  // namespace blossom::planar
