#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// The region with its arcs divided where two of them touch from within, as a round hole touches a round outline: there a
/// chord of the larger arc cuts into the smaller one, or lies on its chord, unless both are cut alike as seen from the place
/// where they touch. They are, as far as chords within the tolerance, or a share of it down to 1/64, are wider than the gap
/// between both arcs. Nothing where none touch. O(n log n + k) for n arcs of which k pairs are near. @throws Error
/// Cancelled.
std::optional<Region> dividedWhereArcsTouch(const Region&, double tolerance, const Progress&);

}  // namespace blossom::planar
