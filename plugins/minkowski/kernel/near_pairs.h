#pragma once
#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// Calls f(i, j) for all pairs of boxes that come within `margin` of one another, each pair once, until f says false.
/// Sorted along the axis on which the boxes are shorter; O(n log n + pairs that overlap on it).
template <class F>
void forEachNearPair(std::span<const Box2> boxes, double margin, const Progress& progress, F f) {
  Vec2 total = Vec2::Zero();
  for (const Box2& box : boxes) total += box.size();
  const int axis = total.x() <= total.y() ? 0 : 1;
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return boxes[a].low[axis] < boxes[b].low[axis]; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    progress.check();
    const Box2& box = boxes[order[k]];
    for (std::size_t l = k + 1; l < order.size(); ++l) {
      const Box2& other = boxes[order[l]];
      if (other.low[axis] > box.high[axis] + margin) break;
      if (other.low[1 - axis] > box.high[1 - axis] + margin || other.high[1 - axis] < box.low[1 - axis] - margin) continue;
      if (!f(order[k], order[l])) return;
    }
  }
}

}  // namespace blossom::minkowski
