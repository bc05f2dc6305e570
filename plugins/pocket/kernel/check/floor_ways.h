#pragma once
#include <vector>

#include "geometry/shape/toolpath.h"
#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

/// Where the tool's centre goes at the floor.
struct FloorWays {
  std::vector<Stroke> strokes;
  std::vector<Vec2> ends;  ///< where a disc is to be added: between ways that do not go straight on
};

FloorWays floorWays(const Toolpath&, double floor);

}  // namespace blossom::pocket
