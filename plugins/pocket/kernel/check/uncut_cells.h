#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "kernel/check/row_slabs.h"
#include "kernel/check/strip_area.h"

namespace blossom::pocket {

/// A piece of what the tool sweeps.
struct UncutCover {
  Slab slab;
  double left = 0, right = 0;  ///< as far as it reaches anywhere
};

/// An upright box, and what of the part and of the sweeps lies in it.
struct UncutCell {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
  std::vector<Rim> rims;
  std::vector<const UncutCover*> covers;
  int depth = 0;  ///< how often it was halved

  [[nodiscard]] std::size_t size() const { return rims.size() + covers.size(); }
  [[nodiscard]] double area() const { return (high - low).prod(); }
};

bool reaches(const UncutCover&, const UncutCell&);

struct UncutCells {
  std::vector<UncutCell> cells;
  std::size_t steps = 0;  ///< curves looked at
};

/// Cells of a few curves each, which together hold all of the part that no single sweep hides.
UncutCells uncutCells(UncutCell whole, const Progress&);

}  // namespace blossom::pocket
