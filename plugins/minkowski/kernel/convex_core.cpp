#include "kernel/convex_core.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blossom::minkowski {
namespace {

constexpr int directions = 24;

Vec2 directionOf(int i) {
  const double angle = 2 * std::numbers::pi * (i + 0.5) / directions;  // no axis, along which many edges run
  return {std::cos(angle), std::sin(angle)};
}

Vec2 toVector(const GridPoint& p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

/// The farthest points of a loop in evenly spread directions: the corners of a convex polygon, counter-clockwise.
GridLoop farthestPoints(const GridLoop& loop) {
  GridLoop corners;
  for (int i = 0; i < directions; ++i) {
    const Vec2 along = directionOf(i);
    const GridPoint farthest = *std::max_element(loop.begin(), loop.end(), [&](const GridPoint& p, const GridPoint& q) {
      return along.dot(toVector(p)) < along.dot(toVector(q));
    });
    if (corners.empty() || (corners.back() != farthest && corners.front() != farthest)) corners.push_back(farthest);
  }
  return corners;
}

GridPoint meanOf(const GridLoop& corners) {
  Wide x = 0, y = 0;
  const auto count = static_cast<Wide>(corners.size());
  for (const GridPoint& p : corners) {
    x += p.x;
    y += p.y;
  }
  return {static_cast<std::int64_t>(x / count), static_cast<std::int64_t>(y / count)};
}

bool isInside(const GridPolygon& polygon, const GridPoint& p) {
  bool inside = false;
  const auto cross = [&](const GridLoop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const GridPoint &from = loop[i], &to = loop[(i + 1) % loop.size()];
      if ((from.y > p.y) == (to.y > p.y)) continue;
      const bool left = minkowski::cross(to - from, p - from) > 0;
      if (left == (to.y > from.y)) inside = !inside;
    }
  };
  cross(polygon.outer);
  for (const GridLoop& hole : polygon.holes) cross(hole);
  return inside;
}

/// The sides of a convex polygon about a point, as linear functions that are 1 on them. None when the point is not inside.
std::vector<Vec2> gaugesOf(const GridLoop& corners, const GridPoint& centre) {
  std::vector<Vec2> gauges;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 from = toVector(corners[i] - centre), along = toVector(corners[(i + 1) % corners.size()] - corners[i]);
    const Vec2 normal(along.y(), -along.x());
    const double reach = normal.dot(from);
    if (!(reach > 0)) return {};
    gauges.emplace_back(normal / reach);
  }
  return gauges;
}

/// How large the polygon of the gauges may be for no edge to reach into it.
double roomFor(const std::vector<Vec2>& gauges, const GridPolygon& polygon, const GridPoint& centre) {
  double room = HUGE_VAL;
  const auto limit = [&](const GridLoop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 from = toVector(loop[i] - centre), to = toVector(loop[(i + 1) % loop.size()] - centre);
      double nearest = 0;
      for (const Vec2& gauge : gauges) nearest = std::max(nearest, std::min(gauge.dot(from), gauge.dot(to)));
      room = std::min(room, nearest);
    }
  };
  limit(polygon.outer);
  for (const GridLoop& hole : polygon.holes) limit(hole);
  return room;
}

constexpr double margin = 1e-5;                             // far more than rounding
constexpr std::int64_t leastWidth = std::int64_t{1} << 24;  // grid units across, for the margin to be many of them

/// In the interior of one part.
GridLoop coreOf(const GridPolygon& polygon) {
  const GridLoop corners = farthestPoints(polygon.outer);
  if (corners.size() < 3) return {};
  const GridPoint centre = meanOf(corners);
  const std::vector<Vec2> gauges = gaugesOf(corners, centre);
  if (gauges.empty() || !isInside(polygon, centre)) return {};
  const double share = roomFor(gauges, polygon, centre) * (1 - margin);
  GridLoop core;
  for (const GridPoint& p : corners) {
    const Vec2 at = share * toVector(p - centre);
    core.push_back(centre + GridPoint{std::llround(at.x()), std::llround(at.y())});
  }
  return core;
}

std::int64_t widthOf(const GridLoop& loop) {
  const auto [low, high] =
      std::minmax_element(loop.begin(), loop.end(), [](const GridPoint& p, const GridPoint& q) { return p.x < q.x; });
  return loop.empty() ? 0 : high->x - low->x;
}

/// The widest of the parts, or a point of the set.
GridLoop coreOf(std::span<const GridPolygon> polygons) {
  GridLoop widest;
  for (const GridPolygon& polygon : polygons)
    if (GridLoop core = coreOf(polygon); widthOf(core) > widthOf(widest)) widest = std::move(core);
  if (widest.empty()) widest.push_back(polygons.front().outer.front());
  return widest;
}

std::size_t cornersOfAll(std::span<const GridPolygon> polygons) {
  std::size_t count = 0;
  for (const GridPolygon& polygon : polygons) {
    count += polygon.outer.size();
    for (const GridLoop& hole : polygon.holes) count += hole.size();
  }
  return count;
}

constexpr std::size_t worthwhile = 20'000;  // pairs of corners; finding the core takes as long as some hundred edges do

}  // namespace

ConvexCore::ConvexCore(GridLoop corners) : corners_(std::move(corners)), centre_(meanOf(corners_)) {
  double inner = HUGE_VAL, outer = 0;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vec2 from = toVector(corners_[i] - centre_), along = toVector(corners_[(i + 1) % corners_.size()] - corners_[i]);
    const Vec2 normal = Vec2(along.y(), -along.x()).normalized();
    const double reach = normal.dot(from) * (1 - margin);
    sides_.push_back({normal.x(), normal.y(), reach});
    inner = std::min(inner, reach);
    outer = std::max(outer, from.norm());
  }
  inner_ = inner > 0 ? inner * inner : 0;
  outer_ = outer * outer;
}

std::optional<ConvexCore> coreOfSum(std::span<const GridPolygon> a, std::span<const GridPolygon> b) {
  if (a.empty() || b.empty() || cornersOfAll(a) * cornersOfAll(b) < worthwhile) return std::nullopt;
  const GridLoop ofA = coreOf(a), ofB = coreOf(b);
  GridLoop sums;
  for (const GridPoint& p : ofA)
    for (const GridPoint& q : ofB) sums.push_back(p + q);
  GridLoop corners = farthestPoints(sums);
  if (corners.size() < 3 || widthOf(corners) < leastWidth) return std::nullopt;
  const std::vector<Vec2> gauges = gaugesOf(corners, meanOf(corners));
  if (gauges.empty()) return std::nullopt;
  return ConvexCore(std::move(corners));
}

}  // namespace blossom::minkowski
