#pragma once
#include "geometry/planar/sums/region_sum.h"

namespace blossom::minkowski {

using namespace planar;

/// Which loops of a boundary.
enum class Boundary { All, Outer, Holes };

/// The points that B covers while its origin runs along the boundary of A, or along its outer loops or holes alone (Lee,
/// Lee, Kim & Kim 2002, figure 3): A' + B without the positions at which -B, moved there, stays inside of the region A' that
/// these loops bound; where B has several parts, the union of what they sweep. The positions are those of
/// minkowskiDifference, so the sweep is never too small.
/// @throws Error as minkowskiSum; InvalidInput where A has no holes to follow.
RegionSumResult outlineSweep(const Region& a, const Region& b, Boundary, const RegionSumOptions& = {},
                             const Progress& = Progress::none());

}  // namespace blossom::minkowski
