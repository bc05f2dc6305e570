#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom::modeling {

/// The area covered by regions, of which some may overlap. Regions that keep apart stay as they are, to the last digit;
/// those that overlap are united by OCCT's Boolean operations.
/// @throws Error InvalidInput when OCCT fails.
Region united(std::vector<Region> regions, const Progress& = Progress::none());

/// The area that closed contours fill by the non-zero rule, also when they cross: each contour that runs as the outermost
/// ones do is an area, less those of the other direction directly in it.
Region nonZeroArea(const std::vector<Path>& contours, const Progress& = Progress::none());

}  // namespace blossom::modeling
