#pragma once
#include <optional>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

struct SharedSides {
  std::optional<Region> without;   ///< the region without them; nothing where no side is shared
  std::optional<Vec2> drawnTwice;  ///< a place on a loop of which nothing would be left
};

/// The region without the sides that its loops run along in opposite senses, as parts do that lie against each other, and
/// slits: both sides of such a line or curve are inside. Loops are cut where the other one begins and ends, and joined
/// there. Nothing is done to regions of lines alone, nor where loops meet in another way. O(n log n + k) for n segments of
/// which k pairs are near.
/// @param tolerance curves, and lines beside shared curves, are one where they lie within a tenth of it and within a
/// millionth of the size; lines alone only within rounding
/// @throws Error Cancelled
SharedSides withoutSharedSides(const Region&, double tolerance, const Progress&);

}  // namespace blossom::planar
