#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/closed_triangles.h"
#include "geometry/shape/bounds.h"

namespace blossom::morphology {

/// The signed distance of a closed surface on a grid, below 0 inside: nearest triangles are found beside the surface and
/// handed on from place to place (P. Danielsson, "Euclidean distance mapping", 1980), so that a few far places may have
/// another triangle than their nearest. Sides are told by the crossings along lines of the grid; bodies that overlap count
/// as one. O(places + triangles and the places near them).
class DistanceGrid {
 public:
  DistanceGrid(std::span<const Triangle3>, double step, const Progress&);

  /// Interpolated; outside of the grid the distance from the box of the surface, which is no larger.
  [[nodiscard]] double operator()(const Vec3&) const;

 private:
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(x);
  }
  [[nodiscard]] Vec3 place(int x, int y, int z) const { return low_ + step_ * Vec3(x, y, z); }
  [[nodiscard]] std::array<std::array<int, 2>, 3> placesBeside(const Triangle3&) const;
  void offer(int x, int y, int z, int triangle);
  void findBesideSurface(const Progress&);
  void handOn(const Progress&);
  void tellSides(const Progress&);

  std::span<const Triangle3> triangles_;
  double step_;
  Bounds box_;
  Vec3 low_ = Vec3::Zero();
  std::array<int, 3> count_{};
  std::vector<int> nearest_;  ///< triangle of each place; -1: none yet
  std::vector<float> distances_;
};

}  // namespace blossom::morphology
