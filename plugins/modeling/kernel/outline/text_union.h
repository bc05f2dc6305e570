#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom::modeling {

/// The union of regions. Disjoint regions are unchanged; overlapping ones are united: those of lines and arcs by
/// booleans/region_boolean.h, others by OCCT.
/// @throws Error InvalidInput when OCCT fails.
Region united(std::vector<Region> regions, const Progress& = Progress::none());

/// The area of closed contours under the non-zero rule, also when they cross: each contour with the orientation of the
/// outermost ones bounds an area, minus those of opposite orientation directly inside.
Region nonZeroArea(const std::vector<Path>& contours, const Progress& = Progress::none());

}  // namespace blossom::modeling
