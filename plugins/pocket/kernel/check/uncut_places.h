#pragma once
#include <vector>

#include "core/progress.h"
#include "kernel/check/floor_ways.h"
#include "kernel/check/uncut.h"
#include "kernel/check/uncut_strips.h"

namespace blossom::pocket {

/// How deep a place must be to count, and what depths are measured from.
struct UncutDepths {
  double radius = 0;      ///< mm, of the tool
  double farAway = 0;     ///< mm from what is cut, where nothing is
  double deepEnough = 0;  ///< mm from what is cut, that a place must reach
};

/// Joins what cells leave uncut into places, the largest first.
std::vector<UncutPlace> uncutPlaces(const std::vector<UncutCell>&, const std::vector<std::vector<UncutStrip>>&,
                                    const UncutFineness&, const FloorWays&, const UncutDepths&, const Progress& joining,
                                    const Progress& measuring);

}  // namespace blossom::pocket
