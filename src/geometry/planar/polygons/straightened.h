#pragma once
#include "geometry/planar/region.h"

namespace blossom::planar {

/// Arcs of circles 10,000 times as large as the path become lines where they leave their chord by less than a thousandth of
/// the tolerance, or by less than a tenth of it and than the rounding of their ends: rounding of centres so far away would
/// show. They end where their neighbours do, if these know better. O(n)
void straighten(Path&, double tolerance);

}  // namespace blossom::planar
