#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/grid.h"
#include "geometry/planar/winding/convolution.h"

namespace blossom::planar {

/// Iterated snap rounding (Halperin & Packer 2002): edges within 0.7 units of a vertex are routed through it and crossings
/// become vertices, until edges meet only in common end points. An edge drifts by less than a unit a round, of which there
/// rarely are more than three.
/// @pre edges run from the lower to the higher point and differ
/// @throws Error Cancelled; Internal when it does not converge.
std::vector<CountedEdge> snapRounded(std::vector<CountedEdge>, const Progress& = Progress::none());

/// The edges of the loops with count 1, as joinEqual returns them.
std::vector<CountedEdge> edgesOf(const std::vector<GridPolygon>&);

/// Whether edges meet only in the corners of their own loops and are otherwise farther apart than a number of units, by
/// default what earlier roundings may have done to their order. May be false where edges are shorter than that.
bool isClear(const std::vector<GridPolygon>&, const Progress& = Progress::none(), double units = 16);

/// The same where loops may also touch in a corner, each other or themselves, but do not cross. Two passes through a corner
/// do not if winding numbers are 0 and 1 all around; three may all the same, so they are not allowed at all.
bool touchesInCorners(const std::vector<GridPolygon>&, const Progress&, double units);

/// The loops as the convolution requires them. Rounding to the grid may make thin parts cross, and a crossing of a single
/// unit changes the winding numbers of a whole sum. Where parts come within a few units of one another, the edges are
/// snap-rounded and the loops rebuilt; otherwise the loops are unchanged.
std::vector<GridPolygon> untangled(std::vector<GridPolygon>, const Progress& = Progress::none());

}  // namespace blossom::planar
