#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// The region with its arcs divided where arcs of two loops touch from within, as a round hole touches a round outline:
/// there a chord of the larger arc always cuts into the smaller one, unless both are drawn from the place where they touch.
/// Nothing where none do. O(n^2) for n arcs. @throws Error Cancelled.
std::optional<Region> dividedWhereArcsTouch(const Region&, const Progress&);

}  // namespace blossom::planar
