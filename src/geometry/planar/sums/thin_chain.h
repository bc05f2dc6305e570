#pragma once
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

struct ChainFit {
  double within = 0;
  bool curved = false;  ///< whether arcs may be meant: the corners of straight outlines may well lie on a circle
};

/// Few lines and arcs within a distance of points that follow one another, from the first to the last of them. O(n log n).
/// @param isRing whether the last point is the first one
/// @throws Error Cancelled
Path fittedChain(const std::vector<Vec2>& points, bool isRing, const ChainFit&, const Progress& = Progress::none());

}  // namespace blossom::planar
