#pragma once
#include <utility>
#include <vector>

#include "kernel/check/row_slabs.h"

namespace blossom::pocket {

/// An interval of x whose ends are linear functions of y between two heights.
struct RunningSpan {
  double leftLow = 0, leftHigh = 0, rightLow = 0, rightHigh = 0;
  [[nodiscard]] double leftMiddle() const { return (leftLow + leftHigh) / 2; }
  [[nodiscard]] double rightMiddle() const { return (rightLow + rightHigh) / 2; }
};

/// The area inside `whole` and outside all `covers` between two heights.
struct StripArea {
  double minimum = 0, maximum = 0;               ///< bounds of the area
  std::vector<std::pair<double, double>> gaps;   ///< approximate intervals at the middle height
  std::vector<std::pair<double, double>> reach;  ///< the same intervals, extended to their maximum within the strip
};

/// Bounds for a strip that lies within the heights of all given slabs. When the order of the interval ends is the same at
/// both heights, the bounds differ only by the bulges of the arcs, else also by the movement of the ends. `slack` is the
/// rounding error of x.
StripArea stripArea(const std::vector<const Slab*>& whole, const std::vector<const Slab*>& covers, double low, double high,
                    double slack);

/// The intervals at one height that lies within the heights of all given slabs.
std::vector<std::pair<double, double>> gapsAt(const std::vector<const Slab*>& whole, const std::vector<const Slab*>& covers,
                                              double y);

}  // namespace blossom::pocket
