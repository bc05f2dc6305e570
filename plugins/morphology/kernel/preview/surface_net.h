#pragma once
#include <array>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// Values at the places of a grid, x fastest.
struct GridValues {
  Vec3 low = Vec3::Zero();
  double step = 1;
  std::array<int, 3> count{};
  std::vector<float> values;

  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(count[0]) +
           static_cast<std::size_t>(x);
  }
};

/// The surface at which the values become 0, as quadrangles around the edges of the grid whose ends differ in sign: one
/// corner in each cell, in the middle of where its edges cross (S. Gibson, "Constrained elastic surface nets", 1998).
/// Closed, and oriented to where values are above 0. O(places). @pre values at the border are above 0
Mesh surfaceNet(const GridValues&, const Progress&);

}  // namespace blossom::morphology
