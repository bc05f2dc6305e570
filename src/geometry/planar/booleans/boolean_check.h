#pragma once
#include "core/progress.h"
#include "geometry/planar/booleans/cut_boundaries.h"
#include "geometry/planar/booleans/region_boolean.h"

namespace blossom::planar {

/// Two regions of lines and arcs, and their boundaries cut where they meet.
struct BooleanOperands {
  const Region &first, &second;
  const CutBoundaries& cut;
};

/// Whether every piece between two cuts bounds the result exactly if it should, which the winding numbers of the other
/// region about three points of it tell, without the polygons that made the result. Points along the other boundary are
/// left out. O(n (log n + k)) for n segments and pieces that are well spread, k of them at the level of a point.
/// @throws Error Cancelled
bool boundsAsItShould(const Region& result, const BooleanOperands&, BooleanOperation, double within, const Progress&);

/// Whether segments end where the next ones begin, to a distance, and none is shorter than another one.
bool isWellJoined(const Region&, double gap, double shortest);

}  // namespace blossom::planar
