#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/vector.h"

namespace blossom::planar {

/// Points of which none are nearer to each other than a distance, so that what rounding made two is one again.
class PointWelder {
 public:
  explicit PointWelder(double within) : within_(within) {}

  /// The first point that was asked for within the distance of p, or else p, which is kept. O(1) for spread points.
  Vec2 welded(const Vec2& p);
  /// The number of the point that is kept within the distance of p, counted from 0 in the order they came.
  [[nodiscard]] std::optional<std::size_t> numberOf(const Vec2& p) const;

 private:
  struct Cell {
    std::int64_t x = 0, y = 0;
    friend bool operator==(const Cell&, const Cell&) = default;
  };
  struct CellHash {
    std::size_t operator()(const Cell&) const;
  };
  [[nodiscard]] Cell cellOf(const Vec2& p) const;

  double within_;
  std::vector<Vec2> points_;
  std::unordered_map<Cell, std::vector<std::size_t>, CellHash> cells_;
};

}  // namespace blossom::planar
