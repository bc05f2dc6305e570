#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "kernel/check/row_slabs.h"
#include "kernel/check/strip_area.h"

namespace blossom::pocket {

/// A piece of the swept area.
struct UncutCover {
  Slab slab;
  double left = 0, right = 0;  ///< its range in x
};

/// An axis-aligned box, and the parts of the outline and of the sweeps in it.
struct UncutCell {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
  std::vector<Rim> rims;
  std::vector<const UncutCover*> covers;
  int depth = 0;  ///< number of halvings

  [[nodiscard]] std::size_t size() const { return rims.size() + covers.size(); }
  [[nodiscard]] double area() const { return (high - low).prod(); }
};

bool reaches(const UncutCover&, const UncutCell&);

struct UncutCells {
  std::vector<UncutCell> cells;
  std::size_t steps = 0;  ///< number of curves processed
};

/// Cells of a few curves each, which together contain every part that no single sweep covers.
UncutCells uncutCells(UncutCell whole, const Progress&);

}  // namespace blossom::pocket
