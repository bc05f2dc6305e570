#include "kernel/convex/convex_sum.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "kernel/convex/normal_cones.h"
#include "kernel/side_by_side.h"

namespace blossom::morphology {

namespace {

constexpr double leastOverlap = 2e-11;  // radians: the normals of faces that rounding has moved differ by less

using Pairs = std::vector<std::array<int, 2>>;

/// Walks along the edges of one polyhedron, which is to say along arcs of normals, through the cones of another.
class Walk {
 public:
  Walk(const NormalCones& edges, const NormalCones& cones) : edges_(edges), cones_(cones) {}

  /// Pairs of a corner of the first and one of the second.
  void collect(Pairs& pairs, const Progress& progress) {
    for (std::size_t v = 0; v < edges_.cornerCount(); ++v) {
      const auto corner = static_cast<int>(v);
      at_ = cones_.highest(edges_.inside(corner), at_);
      pairs.push_back({corner, at_});
    }
    for (const NormalCones::Edge& edge : edges_.edges()) {
      progress.check();
      along(edge, pairs);
    }
  }

 private:
  void along(const NormalCones::Edge& edge, Pairs& pairs) {
    const Vec3 &first = edges_.normal(edge.left), &last = edges_.normal(edge.right);
    at_ = cones_.highest(first, at_);
    double from = 0;
    for (std::size_t steps = 0; steps <= cones_.cornerCount(); ++steps) {
      const NormalCones::Way on = cones_.leftBetween(first, last, at_, from);
      const double middle = (from + on.share) / 2;
      const Vec3 normal = ((1 - middle) * first + middle * last).normalized();
      for (const int corner : {edge.from, edge.to})
        if (overlap(corner, normal)) pairs.push_back({corner, at_});
      if (on.to < 0) return;
      at_ = on.to, from = on.share;
    }
  }

  /// Whether the cone of the corner reached goes on from a normal on the border of the other one into it.
  [[nodiscard]] bool overlap(int corner, const Vec3& normal) const {
    const Vec3& inside = edges_.inside(corner);
    const Vec3 into = (inside - inside.dot(normal) * normal).normalized();
    return cones_.holds(at_, normal + leastOverlap * into);
  }

  const NormalCones &edges_, &cones_;
  int at_ = 0;  ///< of the second, where the walk is
};

}  // namespace

std::vector<std::array<int, 2>> cornersOfSum(const Mesh& a, const Mesh& b, const Progress& progress) {
  std::optional<NormalCones> first, second;
  sideBySide(
      progress, [&] { first.emplace(a); }, [&] { second.emplace(b); });
  Pairs pairs, turned;
  sideBySide(
      progress, [&] { Walk(*first, *second).collect(pairs, progress); },
      [&] { Walk(*second, *first).collect(turned, progress); });
  for (const auto& [ofSecond, ofFirst] : turned) pairs.push_back({ofFirst, ofSecond});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<Vec3> pointsOfSum(const Mesh& a, double weightA, const Mesh& b, double weightB,
                              std::span<const std::array<int, 2>> corners) {
  std::vector<Vec3> sums;
  sums.reserve(corners.size());
  for (const auto& [i, j] : corners)
    sums.push_back(weightA * a.points[static_cast<std::size_t>(i)] + weightB * b.points[static_cast<std::size_t>(j)]);
  return sums;
}

}  // namespace blossom::morphology
