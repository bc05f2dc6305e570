#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/grid.h"

namespace blossom::planar {

/// For every loop the innermost loop that contains it; empty for outermost loops. Unlike those of `loopsAround`, loops may
/// touch one another in points. Nothing where one runs along another, so that no corner and no middle of its sides tells
/// where it lies. Exact. O(n^2) for n corners, less for loops far apart.
/// @pre the loops do not cross. @throws Error Cancelled
std::optional<std::vector<std::optional<std::size_t>>> touchingLoopsAround(const std::vector<GridLoop>&,
                                                                           const Progress& = Progress::none());

}  // namespace blossom::planar
