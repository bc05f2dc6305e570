#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// The region without the sides that its loops run along in opposite senses, as parts do that lie against each other, and
/// slits: both sides of such a line or curve are inside. Loops are cut where the other one begins and ends, and joined
/// there. Nothing is done to regions of lines alone, nor where loops meet in another way. O(n log n + k) for n segments of
/// which k pairs are near.
/// @param tolerance curves, and lines beside shared curves, are one where they lie within a tenth of it and within a
/// millionth of the size; lines alone only within rounding
/// @returns nothing where no side is shared. @throws Error Cancelled
std::optional<Region> withoutSharedSides(const Region&, double tolerance, const Progress&);

}  // namespace blossom::planar
