#pragma once
#include <array>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/numeric/box_tree.h"

/// Exact distances between points, segments and triangles, and between many triangles (Ericson, Real-Time Collision
/// Detection, chapter 5). Hand-written because CGAL's squared_distance returns no foot points.
namespace blossom {

using Triangle3 = std::array<Vec3, 3>;

inline Box3 boxOf(const Triangle3& t) { return Box3(t[0]).extend(t[1]).extend(t[2]); }

/// The nearest points of two objects.
struct FootPoints {
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();
  [[nodiscard]] double distance() const { return (second - first).norm(); }
};

Vec3 closestOnTriangle(const Vec3& point, const Triangle3&);
/// Segments may have length zero.
FootPoints closestOnSegments(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);
/// The same point twice where the triangles intersect. Triangles may be degenerate: segments or points.
FootPoints closestOnTriangles(const Triangle3&, const Triangle3&);

/// Distances between many triangles; points and segments go as collapsed triangles.
class TriangleTree {
 public:
  /// O(n log n). @pre not empty
  explicit TriangleTree(std::vector<Triangle3>);
  [[nodiscard]] const std::vector<Triangle3>& triangles() const { return triangles_; }
  /// The nearest points of two sets of triangles. About O(log n) for sets that do not touch. @throws Error Cancelled
  [[nodiscard]] FootPoints closest(const TriangleTree&, const Progress&) const;
  /// Triangles whose boxes come within `reach` of the box of any of the other triangles.
  [[nodiscard]] std::vector<std::size_t> within(const TriangleTree&, double reach, const Progress&) const;

 private:
  friend struct NearestTriangles;
  std::vector<Triangle3> triangles_;
  BoxTree<3> tree_;
};

}  // namespace blossom
