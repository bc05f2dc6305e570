#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "core/angle.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/planar_bezier.h"

namespace blossom::test {

/// Distances to the curves of a region as drawn: branch and bound in the hulls of poles. Shares no search with the kernels:
/// no flattening, no Newton's iteration.
class TrueDistance {
 public:
  explicit TrueDistance(const std::vector<Path>& paths, double accuracy = 1e-8) : accuracy_(accuracy) {
    for (const Path& path : paths)
      for (const Segment& segment : path.segments) {
        if (const auto* line = std::get_if<Line2>(&segment))
          take(BezierPiece{{line->from.x(), line->from.y(), 1}, {line->to.x(), line->to.y(), 1}});
        else if (const auto* arc = std::get_if<Arc2>(&segment))
          take(ellipticArc(arc->center, {arc->radius, 0}, 1, arc->start, arc->sweep));
        else
          take(std::get<Spline2>(segment));
      }
  }

  struct Foot {
    double distance = std::numeric_limits<double>::infinity();
    Vec2 at = Vec2::Zero();
  };

  [[nodiscard]] double operator()(const Vec2& x) const { return nearest(x).distance; }
  [[nodiscard]] Foot nearest(const Vec2& x) const { return nearestBeyond(x, Vec2::Zero(), -1); }

  /// The nearest point that is no nearer to `center` than `radius`.
  [[nodiscard]] Foot nearestBeyond(const Vec2& x, const Vec2& center, double radius) const {
    Foot best;
    const auto consider = [&](const Vec2& p) {
      const double distance = (p - x).norm();
      if (distance < best.distance && (p - center).norm() >= radius) best = {distance, p};
    };
    const auto farther = [](const Open& a, const Open& b) { return a.minimum > b.minimum; };
    std::priority_queue<Open, std::vector<Open>, decltype(farther)> open(farther);
    const auto push = [&](std::size_t node) {
      if (const double minimum = nodes_[node].toBox(x); minimum < best.distance) open.push({minimum, node});
    };
    for (const std::size_t root : roots_) {
      consider(nodes_[root].from);
      push(root);
    }
    while (!open.empty() && open.top().minimum < best.distance - accuracy_) {
      const std::size_t node = open.top().node;
      open.pop();
      if (nodes_[node].isWithin(center, radius)) continue;
      if (nodes_[node].bulge < accuracy_ / 2) {
        onChord(nodes_[node].from, nodes_[node].to, x, center, radius, consider);
        continue;
      }
      for (const std::size_t child : childrenOf(node)) {
        consider(nodes_[child].from);
        push(child);
      }
    }
    return best;
  }

 private:
  /// A Bézier piece; its halves are made when a search first asks for them.
  struct Node {
    BezierPiece poles;
    Vec2 low, high, from, to;
    double bulge = 0;  ///< mm by which poles, and so the curve, leave the chord
    std::size_t children = 0;

    [[nodiscard]] double toBox(const Vec2& x) const { return (low - x).cwiseMax(x - high).cwiseMax(Vec2::Zero()).norm(); }
    [[nodiscard]] bool isWithin(const Vec2& center, double radius) const {
      return radius > 0 &&
             std::all_of(poles.begin(), poles.end(), [&](const Vec3& p) { return (euclidean(p) - center).norm() < radius; });
    }
  };
  struct Open {
    double minimum;
    std::size_t node;
  };

  void take(const Spline2& spline) {
    for (BezierPiece& piece : bezierPieces(spline)) take(std::move(piece));
  }
  void take(BezierPiece piece) {
    roots_.push_back(nodes_.size());
    nodes_.push_back(nodeOf(std::move(piece)));
  }
  static Node nodeOf(BezierPiece poles) {
    Node node;
    node.from = node.low = node.high = euclidean(poles.front());
    node.to = euclidean(poles.back());
    for (const Vec3& pole : poles) {
      const Vec2 p = euclidean(pole);
      node.low = node.low.cwiseMin(p);
      node.high = node.high.cwiseMax(p);
      node.bulge = std::max(node.bulge, (node.from + shareOf(node.from, node.to, p) * (node.to - node.from) - p).norm());
    }
    node.poles = std::move(poles);
    return node;
  }
  std::array<std::size_t, 2> childrenOf(std::size_t node) const {
    if (nodes_[node].children == 0) {
      auto [first, second] = halves(nodes_[node].poles);
      nodes_[node].children = nodes_.size();
      nodes_.push_back(nodeOf(std::move(first)));
      nodes_.push_back(nodeOf(std::move(second)));
    }
    return {nodes_[node].children, nodes_[node].children + 1};
  }
  static double shareOf(const Vec2& a, const Vec2& b, const Vec2& x) {
    const double squared = (b - a).squaredNorm();
    return squared > 0 ? std::clamp((x - a).dot(b - a) / squared, 0.0, 1.0) : 0;
  }
  /// The foot on a chord, and where the chord leaves the disc.
  template <class Consider>
  static void onChord(const Vec2& a, const Vec2& b, const Vec2& x, const Vec2& center, double radius,
                      const Consider& consider) {
    consider(a + shareOf(a, b, x) * (b - a));
    const double squared = (b - a).squaredNorm();
    if (radius <= 0 || !(squared > 0)) return;
    const double middle = (center - a).dot(b - a) / squared;
    const double half = radius * radius - (a + middle * (b - a) - center).squaredNorm();
    if (half <= 0) return;
    const double reach = std::sqrt(half / squared) * (1 + 1e-9);
    for (const double t : {middle - reach, middle + reach})
      if (t > 0 && t < 1) consider(a + t * (b - a));
  }

  double accuracy_;
  std::vector<std::size_t> roots_;
  mutable std::vector<Node> nodes_;  ///< not for several threads
};

/// How often the loops turn around x: 1 inside a region, 0 outside.
inline int windingAround(const std::vector<Path>& loops, const Vec2& x) {
  int turns = 0;
  for (const Path& loop : loops) turns += windingNumber(loop, x);
  return turns;
}

}  // namespace blossom::test
