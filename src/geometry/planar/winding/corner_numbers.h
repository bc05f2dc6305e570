#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/planar/polygons/grid.h"

namespace blossom::planar {

/// Numbers of the corners of a set, and of the edges that begin there.
class CornerNumbers {
 public:
  static constexpr std::uint32_t unknown = ~std::uint32_t(0);

  /// Numbers the corners from 0 on. Those that are equal, where loops touch, are told apart by the corners after them.
  void add(const GridPoint& at, const GridPoint& next);
  [[nodiscard]] std::uint32_t of(const GridPoint& corner, const GridPoint& next) const;
  /// The edge that leads from a corner to the next one, or the longest of some where corners between them were dropped.
  [[nodiscard]] std::uint32_t ofEdge(const GridPoint& from, const GridPoint& to) const;

 private:
  struct PointHash {
    std::size_t operator()(const GridPoint&) const;
  };
  std::unordered_map<GridPoint, std::uint32_t, PointHash> numbers_;  ///< of corners that are equal, the last
  std::unordered_map<GridPoint, std::vector<std::uint32_t>, PointHash> equal_;
  std::vector<GridPoint> next_;
};

}  // namespace blossom::planar
