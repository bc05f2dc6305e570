#pragma once
#include <utility>
#include <vector>

#include "kernel/check/row_slabs.h"

namespace blossom::pocket {

/// An interval of x whose ends run straight from one height to another.
struct RunningSpan {
  double leftLow = 0, leftHigh = 0, rightLow = 0, rightHigh = 0;
  [[nodiscard]] double leftMiddle() const { return (leftLow + leftHigh) / 2; }
  [[nodiscard]] double rightMiddle() const { return (rightLow + rightHigh) / 2; }
};

/// What lies in `whole` and in none of `covers` between two heights.
struct StripArea {
  double minimum = 0, most = 0;                  ///< bounds of the area
  std::vector<std::pair<double, double>> gaps;   ///< about its intervals at the middle height
  std::vector<std::pair<double, double>> reach;  ///< the same, as far as they reach anywhere in the strip
};

/// Bounds for a strip that every slab given spans. Where the order of the intervals' ends is the same at both heights, the
/// bounds differ by the bulges of the arcs alone; else by how far the ends run. `slack` is what rounding may do to x.
StripArea stripArea(const std::vector<const Slab*>& whole, const std::vector<const Slab*>& covers, double low, double high,
                    double slack);

/// The intervals at one height that all slabs given reach.
std::vector<std::pair<double, double>> gapsAt(const std::vector<const Slab*>& whole, const std::vector<const Slab*>& covers,
                                              double y);

}  // namespace blossom::pocket
