#pragma once
#include <vector>

#include "geometry/planar/polygons/grid.h"
#include "geometry/planar/polygons/polygons.h"

namespace blossom::planar {

/// Two sets on grids of one unit, 2^-46 of the larger extent, each about the middle of its box.
struct SnappedOperands {
  std::vector<GridPolygon> a, b;
  Grid gridA, gridB;
  Grid gridOfSum;  ///< its origin is the sum of theirs
};

/// @pre neither is empty
SnappedOperands snappedTogether(const Polygons& a, const Polygons& b);

}  // namespace blossom::planar
