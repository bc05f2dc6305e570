#include "geometry/mesh/triangle_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>

namespace blossom {

namespace {

double clamp01(double t) { return std::clamp(t, 0.0, 1.0); }

Vec3 closestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  return square > 0 ? Vec3(a + clamp01((p - a).dot(along) / square) * along) : a;
}

void keep(FootPoints& best, const FootPoints& candidate) {
  if ((candidate.second - candidate.first).squaredNorm() < (best.second - best.first).squaredNorm()) best = candidate;
}

/// Where a segment goes through the inside of a triangle.
std::optional<Vec3> crossing(const Vec3& from, const Vec3& to, const Triangle3& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double before = (from - t[0]).dot(normal), after = (to - t[0]).dot(normal);
  if (before * after > 0 || before == after) return std::nullopt;
  const Vec3 point = from + before / (before - after) * (to - from);
  for (std::size_t i = 0; i < 3; ++i)
    if ((t[(i + 1) % 3] - t[i]).cross(point - t[i]).dot(normal) < 0) return std::nullopt;
  return point;
}

}  // namespace

Vec3 closestOnTriangle(const Vec3& p, const Triangle3& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double square = normal.squaredNorm();
  bool inside = square > 0;
  for (std::size_t i = 0; i < 3 && inside; ++i) inside = (t[(i + 1) % 3] - t[i]).cross(p - t[i]).dot(normal) >= 0;
  if (inside) return p - (p - t[0]).dot(normal) / square * normal;
  Vec3 best = closestOnSegment(p, t[0], t[1]);
  for (std::size_t i = 1; i < 3; ++i) {
    const Vec3 candidate = closestOnSegment(p, t[i], t[(i + 1) % 3]);
    if ((candidate - p).squaredNorm() < (best - p).squaredNorm()) best = candidate;
  }
  return best;
}

FootPoints closestOnSegments(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  // The nearest points of the lines, if both are on the segments; else one of them is one of the four ends.
  FootPoints best{a0, closestOnSegment(a0, b0, b1)};
  keep(best, {a1, closestOnSegment(a1, b0, b1)});
  keep(best, {closestOnSegment(b0, a0, a1), b0});
  keep(best, {closestOnSegment(b1, a0, a1), b1});
  const Vec3 a = a1 - a0, b = b1 - b0, between = b0 - a0;
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b);
  const double determinant = aa * bb - ab * ab;
  if (determinant <= 1e-24 * aa * bb) return best;
  const double s = (between.dot(a) * bb - between.dot(b) * ab) / determinant;
  const double t = (between.dot(a) * ab - between.dot(b) * aa) / determinant;
  if (s >= 0 && s <= 1 && t >= 0 && t <= 1) keep(best, {a0 + s * a, b0 + t * b});
  return best;
}

FootPoints closestOnTriangles(const Triangle3& a, const Triangle3& b) {
  FootPoints best{a[0], closestOnTriangle(a[0], b)};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a0 = a[i], &a1 = a[(i + 1) % 3], &b0 = b[i], &b1 = b[(i + 1) % 3];
    if (const auto point = crossing(a0, a1, b)) return {*point, *point};
    if (const auto point = crossing(b0, b1, a)) return {*point, *point};
    keep(best, {a0, closestOnTriangle(a0, b)});
    keep(best, {closestOnTriangle(b0, a), b0});
    for (std::size_t j = 0; j < 3; ++j) keep(best, closestOnSegments(a0, a1, b[j], b[(j + 1) % 3]));
  }
  return best;
}

TriangleTree::TriangleTree(std::vector<Triangle3> triangles) : triangles_(std::move(triangles)) {
  std::vector<Box3> boxes;
  boxes.reserve(triangles_.size());
  for (const Triangle3& triangle : triangles_) boxes.push_back(boxOf(triangle));
  tree_ = BoxTree<3>(boxes);
}

/// Walks two trees at once, the nearer pair of boxes first.
struct NearestTriangles {
  const TriangleTree& a;
  const TriangleTree& b;
  const Progress& progress;
  FootPoints best;
  double distance;

  void walk(std::uint32_t i, std::uint32_t j) {
    const auto &x = a.tree_.nodes()[i], &y = b.tree_.nodes()[j];
    if (boxDistance(x.box, y.box) >= distance) return;
    if (x.isLeaf() && y.isLeaf()) {
      compare(x, y);
      return;
    }
    const bool splitFirst = !x.isLeaf() && (y.isLeaf() || x.box.diagonal().norm() >= y.box.diagonal().norm());
    std::array<std::pair<std::uint32_t, std::uint32_t>, 2> next{
        std::pair{splitFirst ? i + 1 : i, splitFirst ? j : j + 1},
        std::pair{splitFirst ? x.right : i, splitFirst ? j : y.right}};
    const auto gap = [&](const auto& pair) {
      return boxDistance(a.tree_.nodes()[pair.first].box, b.tree_.nodes()[pair.second].box);
    };
    if (gap(next[1]) < gap(next[0])) std::swap(next[0], next[1]);
    for (const auto& [p, q] : next) walk(p, q);
  }

 private:
  void compare(const BoxTree<3>::Node& x, const BoxTree<3>::Node& y) {
    progress.check();
    for (std::uint32_t p = x.first; p < x.first + x.count; ++p)
      for (std::uint32_t q = y.first; q < y.first + y.count; ++q) {
        const FootPoints found = closestOnTriangles(a.triangles_[a.tree_.order()[p]], b.triangles_[b.tree_.order()[q]]);
        if (found.distance() >= distance) continue;
        best = found;
        distance = found.distance();
      }
  }
};

FootPoints TriangleTree::closest(const TriangleTree& other, const Progress& progress) const {
  const FootPoints any{triangles_[0][0], other.triangles_[0][0]};
  NearestTriangles search{*this, other, progress, any, any.distance()};
  search.walk(0, 0);
  return search.best;
}

std::vector<std::size_t> TriangleTree::within(const TriangleTree& other, double reach, const Progress& progress) const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    if (i % 1024 == 0) progress.check();
    const Box3 box = boxOf(triangles_[i]);
    bool found = false;
    other.tree_.walk([&](const Box3& around) { return boxDistance(box, around); },
                     [&](std::size_t k) { found = found || boxDistance(box, boxOf(other.triangles_[k])) <= reach; },
                     [&](double away) { return !found && away <= reach; });
    if (found) result.push_back(i);
  }
  return result;
}

}  // namespace blossom
