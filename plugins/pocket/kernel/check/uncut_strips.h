#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "kernel/check/strip_area.h"
#include "kernel/check/uncut_cells.h"

namespace blossom::pocket {

/// A strip with sufficiently close bounds of its area.
struct UncutStrip {
  double low = 0, high = 0;
  double at = 0;  ///< the height of its gaps
  StripArea area;
};

/// Accuracy and limits of the strips.
struct UncutFineness {
  double perBox = 0, perCell = 0;  ///< mm2, allowed difference of the bounds: per mm2 of a box, and in addition per cell
  double work = 0;                 ///< maximum number of slabs processed per cell, in addition to those of every strip
  double thinnest = 0;             ///< mm: strips of less height are not halved
  double slack = 0;                ///< rounding error of x
  double same = 0;                 ///< heights closer than this are equal
  double apart = 0;                ///< distance of the rows that are drawn
  /// The first row at or above a height, and whether there is a row at it.
  [[nodiscard]] double rowFrom(double y) const { return apart * std::ceil((y - slack) / apart); }
  [[nodiscard]] bool isRow(double y) const { return rowFrom(y) - y <= slack; }
};

struct UncutStrips {
  std::vector<UncutStrip> strips;  ///< from below
  std::size_t steps = 0;           ///< number of curves processed
};

UncutStrips uncutStrips(const UncutCell&, const UncutFineness&, const Progress&);

}  // namespace blossom::pocket
