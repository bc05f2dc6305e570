#pragma once
#include <vector>

#include "core/vector.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// A convex polyhedron by its Gauss map: a corner is the cone of outward normals for which it is the highest point, an edge
/// the arc between the normals of its faces.
class NormalCones {
 public:
  struct Edge {
    int from = 0, to = 0;     ///< corners
    int left = 0, right = 0;  ///< faces
  };

  /// @pre closed triangles, counter-clockwise seen from outside; all points are corners of faces
  explicit NormalCones(const Mesh& triangles);

  [[nodiscard]] std::size_t cornerCount() const { return points_.size(); }
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  [[nodiscard]] const Vec3& normal(int face) const { return normals_[static_cast<std::size_t>(face)]; }
  /// A unit normal inside the cone of a corner.
  [[nodiscard]] const Vec3& inside(int corner) const { return inside_[static_cast<std::size_t>(corner)]; }

  /// The corner highest in a direction, found by climbing from another one.
  [[nodiscard]] int highest(const Vec3& direction, int from) const;
  /// Whether no neighbour of a corner is higher in a direction.
  [[nodiscard]] bool holds(int corner, const Vec3& direction) const;

  struct Way {
    double share = 1;  ///< of the way between the directions, where the cone is left
    int to = -1;       ///< the corner whose cone follows; -1: it is not left
  };
  /// Where the line of directions from `first` to `last` leaves the cone of a corner after a share of the way.
  [[nodiscard]] Way leftBetween(const Vec3& first, const Vec3& last, int corner, double after) const;

 private:
  [[nodiscard]] const Vec3& point(int corner) const { return points_[static_cast<std::size_t>(corner)]; }
  [[nodiscard]] const std::vector<int>& around(int corner) const { return around_[static_cast<std::size_t>(corner)]; }

  std::vector<Vec3> points_, normals_, inside_;
  std::vector<std::vector<int>> around_;  ///< the corners beside each
  std::vector<Edge> edges_;
};

}  // namespace blossom::morphology
