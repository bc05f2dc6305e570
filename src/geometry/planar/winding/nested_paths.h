#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// The region of closed paths, outer ones counter-clockwise and holes clockwise, each outer one followed by its holes.
/// Nothing where paths touch or cross, within the tolerance of curves, or where the sense of one does not fit where it lies.
std::optional<Region> nestedPaths(const std::vector<Path>&, double tolerance, const Progress& = Progress::none());
/// The same of paths that may touch in points. @pre they do not cross
std::optional<Region> nestedTouchingPaths(const std::vector<Path>&, double tolerance, const Progress& = Progress::none());

}  // namespace blossom::planar
