#pragma once
#include "geometry/region.h"

namespace blossom::modeling {

/// A region whose splines have become arcs that touch each other, within `tolerance` mm: each piece of a spline gets two
/// arcs with its end tangents (Bolton 1975), halved until they are near enough. Lines and arcs stay as they are.
struct ArcFitOptions {
  double tolerance = 5e-3;
};
struct ArcFitResult {
  Region region;
  int splines = 0;       ///< how many there were
  double deviation = 0;  ///< largest distance found between a spline and its arcs
};
ArcFitResult fitArcs(const Region&, const ArcFitOptions& = {});

}  // namespace blossom::modeling
