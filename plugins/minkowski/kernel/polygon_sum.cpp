#include "kernel/polygon_sum.h"

#include <algorithm>
#include <cmath>

#include "kernel/convolution.h"
#include "kernel/grid.h"
#include "kernel/snap_rounding.h"
#include "kernel/winding_faces.h"

namespace blossom::minkowski {
namespace {

constexpr double crumb = 4;  // grid units within which a corner is straight and a loop is nothing

bool straight(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 along = c - a;
  const double reach = along.norm();
  if (reach <= crumb) return true;  // an antenna, or neighbours that are one point
  return std::abs(cross(along, Vec2(b - a))) <= crumb * reach && (b - a).dot(along) >= 0 && (c - b).dot(along) >= 0;
}

/// Without collinear points; empty when nothing of any width is left.
Loop withoutCrumbs(const Loop& loop) {
  Loop kept;
  for (const Vec2& p : loop) {
    while (kept.size() >= 2 && straight(kept[kept.size() - 2], kept.back(), p)) kept.pop_back();
    if (kept.empty() || (kept.back() - p).norm() > crumb) kept.push_back(p);
  }
  while (kept.size() >= 3) {
    if (straight(kept[kept.size() - 2], kept.back(), kept.front()))
      kept.pop_back();
    else if (straight(kept.back(), kept.front(), kept[1]))
      kept.erase(kept.begin());
    else
      break;
  }
  double perimeter = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) perimeter += (kept[(i + 1) % kept.size()] - kept[i]).norm();
  if (kept.size() < 3 || std::abs(signedArea(kept)) <= crumb * perimeter) return {};
  return kept;
}

Loop placed(const Loop& loop, const Grid& grid) {
  Loop result;
  result.reserve(loop.size());
  for (const Vec2& p : withoutCrumbs(loop)) result.push_back(grid.point(p));
  return result;
}

Polygons placed(const Polygons& polygons, const Grid& grid) {
  Polygons result;
  for (const Polygon& polygon : polygons) {
    Polygon image{placed(polygon.outer, grid), {}};
    if (image.outer.empty()) continue;
    for (const Loop& hole : polygon.holes)
      if (Loop loop = placed(hole, grid); !loop.empty()) image.holes.push_back(std::move(loop));
    result.push_back(std::move(image));
  }
  return result;
}

bool isConvex(const std::vector<GridPolygon>& polygons) {
  if (polygons.size() != 1 || !polygons.front().holes.empty()) return false;
  const GridLoop& p = polygons.front().outer;
  const std::size_t n = p.size();
  int changes = 0;  // of the sign of dx: a convex loop has two, one that winds twice has four
  for (std::size_t i = 0; i < n; ++i) {
    const GridPoint in = p[(i + 1) % n] - p[i], out = p[(i + 2) % n] - p[(i + 1) % n];
    if (cross(in, out) <= 0) return false;
    const auto forward = [](const GridPoint& d) { return d.x > 0 || (d.x == 0 && d.y > 0); };
    if (forward(in) != forward(out)) ++changes;
  }
  return changes == 2;
}

GridLoop fromLowest(GridLoop loop) {
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  return loop;
}

/// Both loops from their lowest points on, whose edges then come sorted by angle.
Loop mergedByAngle(const GridLoop& first, const GridLoop& second) {
  const GridLoop a = fromLowest(first), b = fromLowest(second);
  Loop sum;
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    const GridPoint corner = a[i % a.size()] + b[j % b.size()];
    sum.emplace_back(static_cast<double>(corner.x), static_cast<double>(corner.y));
    const GridPoint alongA = a[(i + 1) % a.size()] - a[i % a.size()], alongB = b[(j + 1) % b.size()] - b[j % b.size()];
    const auto forward = [](const GridPoint& d) { return d.x > 0 || (d.x == 0 && d.y > 0); };
    Wide order = cross(alongA, alongB);
    if (forward(alongA) != forward(alongB)) order = forward(alongA) ? 1 : -1;  // the lower chain comes first
    if (j == b.size() || (i < a.size() && order >= 0))
      ++i;
    else
      ++j;
  }
  return sum;
}

Loop reversed(const Loop& loop) { return {loop.rbegin(), loop.rend()}; }

/// Loops may touch in points, so the most of the corners decide.
bool holds(const Loop& outer, const Loop& inner) {
  const auto within = std::count_if(inner.begin(), inner.end(), [&](const Vec2& p) { return encloses(outer, p); });
  return 2 * within > static_cast<std::ptrdiff_t>(inner.size());
}

/// The bounded parts of the complement: each hole, without the parts that lie in it.
Polygons boundedComplement(const Polygons& polygons) {
  Polygons result;
  for (const Polygon& polygon : polygons)
    for (const Loop& hole : polygon.holes) result.push_back({reversed(hole), {}});
  const std::size_t count = result.size();
  for (const Polygon& polygon : polygons) {
    std::size_t owner = count;
    for (std::size_t i = 0; i < count; ++i) {
      const bool smaller = owner == count || signedArea(result[i].outer) < signedArea(result[owner].outer);
      if (smaller && signedArea(result[i].outer) > signedArea(polygon.outer) && holds(result[i].outer, polygon.outer))
        owner = i;
    }
    if (owner < count) result[owner].holes.push_back(reversed(polygon.outer));
  }
  return result;
}

}  // namespace

Polygons sum(const Polygons& a, const Polygons& b, const Progress& progress) {
  progress.check();
  if (a.empty() || b.empty()) return {};
  const Box2 boxA = boxOf(a), boxB = boxOf(b);
  const Grid gridA{(boxA.low + boxA.high) / 2, gridUnit(boxA.size().cwiseMax(boxB.size()))};
  const Grid gridB{(boxB.low + boxB.high) / 2, gridA.unit};
  const Grid grid{gridA.origin + gridB.origin, gridA.unit};
  const std::vector<GridPolygon> snappedA = snapped(a, gridA), snappedB = snapped(b, gridB);
  if (isConvex(snappedA) && isConvex(snappedB))
    return placed({{mergedByAngle(snappedA.front().outer, snappedB.front().outer), {}}}, grid);
  const std::vector<CountedEdge> edges = convolution(untangled(snappedA, progress), untangled(snappedB, progress), progress);
  return placed(windingFaces(edges, progress), grid);
}

Polygons difference(const Polygons& a, const Polygons& b, const Progress& progress) {
  if (a.empty()) return {};
  // The complement within a frame that B, wherever it meets A, does not reach.
  const Box2 boxA = boxOf(a), boxB = boxOf(b);
  const Vec2 reach = 2 * boxB.size() + boxA.size();
  const Vec2 low = boxA.low - reach, high = boxA.high + reach;
  Polygons outside{{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}}};
  for (const Polygon& polygon : a) {
    outside.front().holes.push_back(reversed(polygon.outer));
    for (const Loop& hole : polygon.holes) outside.push_back({reversed(hole), {}});
  }
  return boundedComplement(sum(outside, scaled(b, -1), progress));
}

}  // namespace blossom::minkowski
