#pragma once
#include <vector>

#include "geometry/shape/toolpath.h"
#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

/// Paths of the tool's centre at the floor.
struct FloorWays {
  std::vector<Stroke> strokes;
  std::vector<Vec2> ends;  ///< centres of discs to add, at joints that are not smooth
};

FloorWays floorWays(const Toolpath&, double floor);

}  // namespace blossom::pocket
