#pragma once
#include <optional>

#include "geometry/shape/motion_edit.h"
#include "kernel/grid/live_grid.h"
#include "scene/picking.h"
#include "scene/ray_tree.h"

namespace blossom::sweep {

/// A place of a swept surface that a ray hits.
struct PlaceHit {
  MotionPlace at;
  Vec3 point = Vec3::Zero();   ///< x(u, v)
  Vec3 normal = Vec3::Zero();  ///< x_u cross x_v, unit length; zero where that vanishes
  double distance = 0;         ///< along the ray
};

/// Finds the parameters under the mouse: the first cell of the grid that the ray goes through, then Newton's method for
/// x(u, v) = ray(s) on the factors. Where the grid is hit and the surface is not, at a silhouette, the point of the surface
/// beside the ray is taken. Thread-safe once built. O(cells log cells) to build, O(log cells + degree^2) for a ray.
class PlaceFinder {
 public:
  /// @param grid must outlive the finder, and not be updated
  explicit PlaceFinder(const LiveGrid& grid);
  [[nodiscard]] std::optional<PlaceHit> find(const Ray&) const;

 private:
  struct Cell;
  [[nodiscard]] std::optional<Cell> firstCell(const Ray&) const;
  [[nodiscard]] PlaceHit refined(const Ray&, const Cell&) const;
  void hitCell(const Ray&, std::size_t cell, Cell& nearest) const;

  const LiveGrid& grid_;
  RayTree cells_;
};

/// The point and normal of the surface at a place inside the domain.
PlaceHit placeHit(const Motion&, const MotionPlace&);

}  // namespace blossom::sweep
