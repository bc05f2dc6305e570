#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "kernel/check/strip_area.h"
#include "kernel/check/uncut_cells.h"

namespace blossom::pocket {

/// A strip whose area is bounded well enough.
struct UncutStrip {
  double low = 0, high = 0;
  double at = 0;  ///< the height of its gaps
  StripArea area;
};

/// How finely strips are measured.
struct UncutFineness {
  double perBox = 0, perCell = 0;  ///< mm2 that bounds may be apart: in a mm2 of box, and besides in every cell
  double work = 0;                 ///< slabs that a cell may look at, above what every strip may
  double thinnest = 0;             ///< mm: lower strips are not halved
  double slack = 0;                ///< what rounding may do to x
  double same = 0;                 ///< heights closer to one another are one
  double apart = 0;                ///< of the rows that are drawn
  /// The first row not below a height, and whether one is there.
  [[nodiscard]] double rowFrom(double y) const { return apart * std::ceil((y - slack) / apart); }
  [[nodiscard]] bool isRow(double y) const { return rowFrom(y) - y <= slack; }
};

struct UncutStrips {
  std::vector<UncutStrip> strips;  ///< from below
  std::size_t steps = 0;           ///< curves looked at
};

UncutStrips uncutStrips(const UncutCell&, const UncutFineness&, const Progress&);

}  // namespace blossom::pocket
