#include "geometry/planar/booleans/point_welder.h"

#include <cmath>
#include <functional>

namespace blossom::planar {

std::size_t PointWelder::CellHash::operator()(const Cell& cell) const {
  constexpr std::size_t mix = 0x9e3779b97f4a7c15U;
  return (std::hash<std::int64_t>()(cell.x) * mix) ^ std::hash<std::int64_t>()(cell.y);
}

PointWelder::Cell PointWelder::cellOf(const Vec2& p) const {
  return {std::llround(p.x() / within_), std::llround(p.y() / within_)};
}

std::optional<std::size_t> PointWelder::numberOf(const Vec2& p) const {
  const Cell cell = cellOf(p);
  for (std::int64_t x = cell.x - 1; x <= cell.x + 1; ++x)
    for (std::int64_t y = cell.y - 1; y <= cell.y + 1; ++y) {
      const auto found = cells_.find({x, y});
      if (found == cells_.end()) continue;
      for (const std::size_t kept : found->second)
        if ((points_[kept] - p).norm() <= within_) return kept;
    }
  return std::nullopt;
}

Vec2 PointWelder::welded(const Vec2& p) {
  if (const auto kept = numberOf(p)) return points_[*kept];
  cells_[cellOf(p)].push_back(points_.size());
  points_.push_back(p);
  return p;
}

}  // namespace blossom::planar
