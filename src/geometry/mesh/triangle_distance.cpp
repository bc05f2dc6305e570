#include "geometry/mesh/triangle_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace blossom {

namespace {

constexpr std::size_t leafSize = 4;

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

double boxDistance(const Vec3& lowA, const Vec3& highA, const Vec3& lowB, const Vec3& highB) {
  return (lowB - highA).cwiseMax(lowA - highB).cwiseMax(0).norm();
}

Vec3 lowOf(const Triangle3& t) { return t[0].cwiseMin(t[1]).cwiseMin(t[2]); }
Vec3 highOf(const Triangle3& t) { return t[0].cwiseMax(t[1]).cwiseMax(t[2]); }

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

TriangleTree::TriangleTree(std::vector<Triangle3> triangles) : triangles_(std::move(triangles)), order_(triangles_.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  nodes_.reserve(triangles_.size());
  build(0, triangles_.size());
}

std::size_t TriangleTree::build(std::size_t begin, std::size_t end) {
  Node node;
  node.low = Vec3::Constant(std::numeric_limits<double>::infinity());
  node.high = -node.low;
  for (std::size_t i = begin; i < end; ++i) {
    node.low = node.low.cwiseMin(lowOf(triangles_[order_[i]]));
    node.high = node.high.cwiseMax(highOf(triangles_[order_[i]]));
  }
  node.begin = begin;
  node.end = end;
  const std::size_t index = nodes_.size();
  nodes_.push_back(node);
  if (end - begin <= leafSize) return index;
  Eigen::Index axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const auto place = [&](std::size_t i) { return triangles_[i][0][axis] + triangles_[i][1][axis] + triangles_[i][2][axis]; };
  const std::size_t middle = (begin + end) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
  const std::size_t left = build(begin, middle);
  const std::size_t right = build(middle, end);
  nodes_[index].left = left;
  nodes_[index].right = right;
  return index;
}

/// Walks two trees at once.
struct TreeWalk {
  const TriangleTree& a;
  const TriangleTree& b;
  const Progress& progress;
  using Node = TriangleTree::Node;

  static double apart(const Node& x, const Node& y) { return boxDistance(x.low, x.high, y.low, y.high); }

  void closest(std::size_t i, std::size_t j, FootPoints& best, double& distance) const {
    const Node &x = a.nodes_[i], &y = b.nodes_[j];
    if (apart(x, y) >= distance) return;
    if (x.left == 0 && y.left == 0) {
      progress.check();
      for (std::size_t p = x.begin; p < x.end; ++p)
        for (std::size_t q = y.begin; q < y.end; ++q) {
          const FootPoints found = closestOnTriangles(a.triangles_[a.order_[p]], b.triangles_[b.order_[q]]);
          if (found.distance() < distance) {
            best = found;
            distance = found.distance();
          }
        }
      return;
    }
    const bool splitFirst = x.left != 0 && (y.left == 0 || (x.high - x.low).norm() >= (y.high - y.low).norm());
    std::array<std::pair<std::size_t, std::size_t>, 2> next{std::pair{splitFirst ? x.left : i, splitFirst ? j : y.left},
                                                            std::pair{splitFirst ? x.right : i, splitFirst ? j : y.right}};
    const auto gap = [&](const auto& pair) { return apart(a.nodes_[pair.first], b.nodes_[pair.second]); };
    if (gap(next[1]) < gap(next[0])) std::swap(next[0], next[1]);
    for (const auto& [p, q] : next) closest(p, q, best, distance);
  }

  [[nodiscard]] bool near(const Vec3& low, const Vec3& high, std::size_t j, double reach) const {
    const Node& y = b.nodes_[j];
    if (boxDistance(low, high, y.low, y.high) > reach) return false;
    if (y.left != 0) return near(low, high, y.left, reach) || near(low, high, y.right, reach);
    for (std::size_t q = y.begin; q < y.end; ++q) {
      const Triangle3& t = b.triangles_[b.order_[q]];
      if (boxDistance(low, high, lowOf(t), highOf(t)) <= reach) return true;
    }
    return false;
  }
};

FootPoints TriangleTree::closest(const TriangleTree& other, const Progress& progress) const {
  FootPoints best{triangles_[0][0], other.triangles_[0][0]};
  double distance = best.distance();
  TreeWalk{*this, other, progress}.closest(0, 0, best, distance);
  return best;
}

std::vector<std::size_t> TriangleTree::within(const TriangleTree& other, double reach, const Progress& progress) const {
  const TreeWalk walk{*this, other, progress};
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    if (i % 1024 == 0) progress.check();
    if (walk.near(lowOf(triangles_[i]), highOf(triangles_[i]), 0, reach)) result.push_back(i);
  }
  return result;
}

}  // namespace blossom
