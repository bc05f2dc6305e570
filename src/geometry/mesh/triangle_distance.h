#pragma once
#include <array>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"

/// Exact distances between points, segments and triangles, and between many triangles (Ericson, Real-Time Collision
/// Detection, chapter 5).
namespace blossom {

using Triangle3 = std::array<Vec3, 3>;

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

/// Bounding-volume tree of triangles; points and segments are stored as degenerate triangles.
class TriangleTree {
 public:
  /// O(n log n). @pre not empty
  explicit TriangleTree(std::vector<Triangle3>);
  [[nodiscard]] const std::vector<Triangle3>& triangles() const { return triangles_; }
  /// The nearest points of two sets of triangles. About O(log n) for sets that do not touch. @throws Error Cancelled
  [[nodiscard]] FootPoints closest(const TriangleTree&, const Progress&) const;
  /// Indices of the triangles whose boxes are at most `reach` away from the box of a triangle of the other tree.
  [[nodiscard]] std::vector<std::size_t> within(const TriangleTree&, double reach, const Progress&) const;

 private:
  struct Node {
    Vec3 low, high;
    std::size_t begin = 0, end = 0;   // of a leaf
    std::size_t left = 0, right = 0;  // 0: a leaf
  };
  friend struct TreeWalk;
  std::size_t build(std::size_t begin, std::size_t end);
  std::vector<Triangle3> triangles_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace blossom
