#pragma once
#include <vector>

#include "kernel/grid/motion_grid.h"

namespace blossom::sweep {

/// Lines of a grid along both parameters through what differs from another grid of the same size, one in `every` rows and
/// columns. Seen in front of everything, it shows the surface wherever it goes. O(places).
std::vector<std::vector<Vec3>> changedNet(const MotionGrid& before, const MotionGrid& now, std::size_t every);

}  // namespace blossom::sweep
