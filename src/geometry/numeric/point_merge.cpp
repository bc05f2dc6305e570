#include "geometry/numeric/point_merge.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace blossom {
namespace {

std::uint64_t hashOf(const std::array<std::uint64_t, 3>& values) {
  std::uint64_t hash = 0;
  for (const std::uint64_t value : values) {
    hash ^= value + 0x9e3779b97f4a7c15ull;
    hash *= 0xff51afd7ed558ccdull;
    hash ^= hash >> 32;
  }
  return hash;
}

/// First points of each cell, chained through `next` so that a cell costs no allocation of its own.
class PointGrid {
 public:
  PointGrid(std::span<const Vec3> points, double distance)
      : points_(points), distance_(distance), width_(4 * distance), next_(points.size(), -1) {
    heads_.reserve(points.size());
  }

  /// The earlier point near point i, or i itself, which then is kept.
  int findOrKeep(int i) {
    const Vec3& p = points_[static_cast<std::size_t>(i)];
    // Cells are four distances wide: mostly one, at most eight of them are within reach.
    const auto from = [&](int axis) { return cell(p[axis] - distance_); };
    const auto to = [&](int axis) { return cell(p[axis] + distance_); };
    for (std::int64_t x = from(0); x <= to(0); ++x)
      for (std::int64_t y = from(1); y <= to(1); ++y)
        for (std::int64_t z = from(2); z <= to(2); ++z)
          if (const int found = near(key(x, y, z), p); found >= 0) return found;
    const auto [head, isNew] = heads_.try_emplace(key(cell(p.x()), cell(p.y()), cell(p.z())), i);
    if (!isNew) {
      next_[static_cast<std::size_t>(i)] = head->second;
      head->second = i;
    }
    return i;
  }

 private:
  std::int64_t cell(double x) const {
    constexpr double farthest = 4e18;
    return std::isfinite(x) ? static_cast<std::int64_t>(std::clamp(std::floor(x / width_), -farthest, farthest)) : 0;
  }

  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    return hashOf({static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y), static_cast<std::uint64_t>(z)});
  }

  int near(std::uint64_t cellKey, const Vec3& p) const {
    const auto head = heads_.find(cellKey);
    if (head == heads_.end()) return -1;
    for (int i = head->second; i >= 0; i = next_[static_cast<std::size_t>(i)])
      if ((points_[static_cast<std::size_t>(i)] - p).squaredNorm() <= distance_ * distance_) return i;
    return -1;
  }

  std::span<const Vec3> points_;
  double distance_;
  double width_;
  std::vector<int> next_;
  std::unordered_map<std::uint64_t, int> heads_;
};

}  // namespace

std::vector<int> mergeClosePoints(std::span<const Vec3> points, double distance) {
  std::vector<int> result(points.size());
  PointGrid grid(points, distance);
  for (std::size_t i = 0; i < points.size(); ++i) result[i] = grid.findOrKeep(static_cast<int>(i));
  return result;
}

std::vector<int> mergeEqualPoints(std::span<const Vec3> points, const Progress& progress) {
  using Bits = std::array<std::uint64_t, 3>;
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };  // -0 + 0 is 0
  const auto hash = [](const Bits& place) { return static_cast<std::size_t>(hashOf(place)); };
  std::unordered_map<Bits, int, decltype(hash)> seen(points.size(), hash);
  std::vector<int> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 4096 == 0) progress.check();
    const Vec3& p = points[i];
    result[i] = seen.try_emplace({bits(p.x()), bits(p.y()), bits(p.z())}, static_cast<int>(i)).first->second;
  }
  return result;
}

}  // namespace blossom
