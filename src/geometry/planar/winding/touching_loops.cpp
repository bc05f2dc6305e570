#include "geometry/planar/winding/touching_loops.h"

#include <algorithm>

namespace blossom::planar {
namespace {

enum class LoopSide { Inside, On, Outside };

/// Of a loop: the grid is twice as fine, so that it has the middles of all sides.
struct DoubledLoop {
  GridLoop corners;
  GridPoint low, high;
  Wide twiceArea = 0;

  explicit DoubledLoop(const GridLoop& loop) {
    for (const GridPoint& p : loop) corners.push_back(p + p);
    low = high = corners.front();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const GridPoint& p = corners[i];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      twiceArea += cross(p - corners.front(), corners[(i + 1) % corners.size()] - corners.front());
    }
    if (twiceArea < 0) twiceArea = -twiceArea;
  }

  [[nodiscard]] bool reachesAround(const DoubledLoop& other) const {
    return low.x <= other.low.x && low.y <= other.low.y && high.x >= other.high.x && high.y >= other.high.y;
  }

  /// By the sides that a ray to the right passes.
  [[nodiscard]] LoopSide sideOf(const GridPoint& p) const {
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const GridPoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
      if (std::max(a.y, b.y) < p.y || std::min(a.y, b.y) > p.y) continue;
      const Wide side = cross(b - a, p - a);
      if (side == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x)) return LoopSide::On;
      if ((a.y <= p.y) != (b.y <= p.y)) inside = inside != ((side > 0) == (b.y > a.y));
    }
    return inside ? LoopSide::Inside : LoopSide::Outside;
  }
};

GridPoint middleOf(const GridPoint& a, const GridPoint& b) { return {a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2}; }

/// Where a loop lies that does not cross another: as any of its points beside the other does.
LoopSide sideOf(const DoubledLoop& loop, const DoubledLoop& other) {
  for (std::size_t i = 0; i < loop.corners.size(); ++i) {
    const GridPoint &from = loop.corners[i], &to = loop.corners[(i + 1) % loop.corners.size()];
    for (const GridPoint& p : {from, middleOf(from, to)})
      if (const LoopSide side = other.sideOf(p); side != LoopSide::On) return side;
  }
  return LoopSide::On;
}

}  // namespace

std::optional<std::vector<std::optional<std::size_t>>> touchingLoopsAround(const std::vector<GridLoop>& loops,
                                                                           const Progress& progress) {
  const std::vector<DoubledLoop> doubled(loops.begin(), loops.end());
  std::vector<std::optional<std::size_t>> around(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t k = 0; k < loops.size(); ++k) {
      progress.check();
      if (k == i || !doubled[k].reachesAround(doubled[i])) continue;
      const LoopSide side = sideOf(doubled[i], doubled[k]);
      if (side == LoopSide::On) return std::nullopt;
      const bool smaller = !around[i] || doubled[k].twiceArea < doubled[*around[i]].twiceArea;
      if (side == LoopSide::Inside && smaller) around[i] = k;
    }
  return around;
}

}  // namespace blossom::planar
