#pragma once
#include <cmath>
#include <cstdint>

#include "core/vector.h"

namespace blossom::pocket {

struct TurnedPoint {
  std::int32_t x = 0, y = 0;
  friend bool operator==(const TurnedPoint&, const TurnedPoint&) = default;
};

/// Integer coordinates, below 2^29, for a square of `size` mm around `middle`, rotated by an angle; the orientation of three
/// points fits into 64 bits.
class TurnedGrid {
 public:
  TurnedGrid(const Vec2& middle, double size, double angle)
      : middle_(middle), scale_(static_cast<double>(1 << 28) / size), turn_(std::cos(angle), std::sin(angle)) {}

  [[nodiscard]] TurnedPoint operator()(const Vec2& p) const {
    const Vec2 q = scale_ * (p - middle_);
    return {static_cast<std::int32_t>(std::lround(turn_.x() * q.x() - turn_.y() * q.y())),
            static_cast<std::int32_t>(std::lround(turn_.y() * q.x() + turn_.x() * q.y()))};
  }
  [[nodiscard]] Vec2 back(double x, double y) const {
    return middle_ + Vec2(turn_.x() * x + turn_.y() * y, turn_.x() * y - turn_.y() * x) / scale_;
  }
  /// mm, spacing of the grid.
  [[nodiscard]] double step() const { return 1 / scale_; }

 private:
  Vec2 middle_;
  double scale_;
  Vec2 turn_;
};

/// Above 0 when c lies to the left of the line from a to b. Exact.
inline std::int64_t orientation(const TurnedPoint& a, const TurnedPoint& b, const TurnedPoint& c) {
  const auto difference = [](std::int32_t p, std::int32_t q) { return std::int64_t{p} - q; };
  return difference(b.x, a.x) * difference(c.y, a.y) - difference(b.y, a.y) * difference(c.x, a.x);
}

}  // namespace blossom::pocket
