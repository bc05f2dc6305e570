#pragma once
#include <vector>

#include "core/progress.h"
#include "kernel/check/floor_ways.h"
#include "kernel/check/uncut.h"
#include "kernel/check/uncut_strips.h"

namespace blossom::pocket {

/// Minimum depth of a listed place, and the reference of depths.
struct UncutDepths {
  double radius = 0;      ///< mm, of the tool
  double farAway = 0;     ///< mm, depth when nothing is cut
  double deepEnough = 0;  ///< mm, minimum depth of a place
};

/// Joins the uncut parts of cells into connected places, the largest first.
std::vector<UncutPlace> uncutPlaces(const std::vector<UncutCell>&, const std::vector<std::vector<UncutStrip>>&,
                                    const UncutFineness&, const FloorWays&, const UncutDepths&, const Progress& joining,
                                    const Progress& measuring);

}  // namespace blossom::pocket
