#pragma once
#include <cmath>

#include "geometry/planar/polygons/grid.h"

namespace blossom::planar {

/// A direction with what tells most of them apart at once.
struct Direction {
  explicit Direction(const GridPoint& by) : along(by) {
    const auto x = static_cast<double>(by.x), y = static_cast<double>(by.y);
    const double share = x / (std::abs(x) + std::abs(y));
    turn = isUpper() ? 1 - share : 3 + share;
  }
  [[nodiscard]] bool isUpper() const { return along.y > 0 || (along.y == 0 && along.x > 0); }

  GridPoint along;
  double turn = 0;  ///< from +x, counter-clockwise: 0 to 4, rounded; grows with the angle. NaN without a direction
};

/// By the angle from +x, counter-clockwise, exactly.
inline bool before(const Direction& a, const Direction& b) {
  constexpr double rounding = 4e-15;  // of both turns, with room
  if (std::abs(a.turn - b.turn) > rounding) return a.turn < b.turn;
  return a.isUpper() != b.isUpper() ? a.isUpper() : cross(a.along, b.along) > 0;
}

}  // namespace blossom::planar
