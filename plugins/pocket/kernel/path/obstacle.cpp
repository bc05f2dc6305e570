#include "kernel/path/obstacle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/stroke/stroke_tree.h"
#include "kernel/stroke/tool_moves.h"

namespace blossom::pocket {

namespace {

/// A convex piece of the shadow: what of a triangle lies above the height.
using Shade = std::vector<Vec2>;

Shade shadeOf(const std::array<Vec3, 3>& triangle, double above) {
  Shade shade;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = triangle[i];
    const Vec3& b = triangle[(i + 1) % 3];
    if (a.z() >= above) shade.emplace_back(a.head<2>());
    if ((a.z() < above) == (b.z() < above)) continue;
    const double share = (above - a.z()) / (b.z() - a.z());
    shade.emplace_back((a + share * (b - a)).head<2>());
  }
  return shade;
}

bool covers(const Shade& shade, const Vec2& p) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < shade.size(); ++i) {
    const double side = cross(Vec2(shade[(i + 1) % shade.size()] - shade[i]), Vec2(p - shade[i]));
    (side > 0 ? left : right) += side != 0 ? 1 : 0;
  }
  return (left > 0) != (right > 0);
}

class Shadow {
 public:
  Shadow(const Triangles& triangles, double above) {
    std::vector<Stroke> edges;
    for (const auto& triangle : triangles) {
      Shade shade = shadeOf(triangle, above);
      if (shade.size() < 2) continue;
      for (const Vec3& corner : triangle) top_ = std::max(top_, corner.z());
      for (std::size_t i = 0; i < shade.size(); ++i) edges.push_back(Stroke::line(shade[i], shade[(i + 1) % shade.size()]));
      shades_.push_back(std::move(shade));
    }
    edges_ = StrokeTree(std::move(edges));
  }

  [[nodiscard]] bool empty() const { return edges_.empty(); }
  [[nodiscard]] double top() const { return top_; }
  [[nodiscard]] double away(const Stroke& way, double bound) const { return edges_.nearest(way, bound).distance; }
  [[nodiscard]] double away(const Vec2& p) const { return edges_.nearest(p).distance; }
  [[nodiscard]] bool contains(const Vec2& p) const {
    return std::any_of(shades_.begin(), shades_.end(), [&](const Shade& shade) { return covers(shade, p); });
  }

 private:
  std::vector<Shade> shades_;
  StrokeTree edges_;
  double top_ = -std::numeric_limits<double>::infinity();
};

/// The sample of a way that lies nearest to the shadow.
Vec2 worstOn(const Stroke& way, const Shadow& shadow) {
  constexpr int samples = 64;
  Vec2 worst = way.from;
  double minimum = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i) {
    const Vec2 at = way.at(static_cast<double>(i) / samples);
    if (const double away = shadow.away(at); away < minimum) minimum = away, worst = at;
  }
  return worst;
}

}  // namespace

std::optional<ObstacleHit> obstacleHit(const Toolpath& path, const Triangles& triangles, const ObstacleOptions& options,
                                       const Progress& progress) {
  const Shadow shadow(triangles, options.above);
  if (shadow.empty()) return std::nullopt;
  const double radius = path.cutter.diameter / 2;
  std::optional<ObstacleHit> worst;
  bool down = false;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (i % 256 == 0) progress.check();
    const Vec3 from = startOf(path, i);
    const ToolMove& move = path.moves[i];
    const double low = std::min(from.z(), move.to.z());
    if (low >= shadow.top()) {
      down = false;
      continue;
    }
    const Stroke way = wayOf(from, move);
    // Who is inside of the shadow came across its edges, or came down there.
    const bool within = !down && shadow.contains(way.from);
    down = true;
    const double depth = within ? radius + shadow.away(way.from) : radius - shadow.away(way, radius);
    if (depth <= options.margin || (worst && depth <= worst->depth)) continue;
    const Vec2 at = within ? way.from : worstOn(way, shadow);
    worst = ObstacleHit{{at.x(), at.y(), low}, depth};
  }
  return worst;
}

}  // namespace blossom::pocket
