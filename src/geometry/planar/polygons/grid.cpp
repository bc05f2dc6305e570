#include "geometry/planar/polygons/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace blossom::planar {
namespace {

constexpr double minimum = 4;       // grid units within which a corner is straight and a loop is nothing
constexpr std::int64_t speck = 16;  // units; rounding leaves no shape to what is smaller

GridLoop snapped(const Loop& loop, const Grid& grid) {
  GridLoop points;
  points.reserve(loop.size());
  for (const Vec2& p : loop) points.push_back(grid.nearest(p));
  return points;
}

/// An outline as it comes out of rounding; empty when that has made it a line. A speck becomes its box, for a part must not
/// vanish: what is added to it is as large as the other set.
GridLoop outlineOf(const GridLoop& points) {
  GridPoint low = points.front(), high = points.front();
  for (const GridPoint& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  if (high.x - low.x > speck || high.y - low.y > speck) return cleaned(points);
  high = {std::max(high.x, low.x + 1), std::max(high.y, low.y + 1)};
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

/// Strips of two units along the edges of an outline that rounding has made a line or a tree of lines.
std::vector<GridLoop> stripsAlong(const GridLoop& points) {
  GridLoop corners;
  for (const GridPoint& p : points) {
    if (!corners.empty() && corners.back() == p) continue;
    if (corners.size() >= 2) {
      const GridPoint in = corners.back() - corners[corners.size() - 2], out = p - corners.back();
      if (cross(in, out) == 0 && dot(in, out) > 0) corners.pop_back();
    }
    corners.push_back(p);
  }
  std::set<std::pair<GridPoint, GridPoint>> edges;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (const auto [low, high] = std::minmax({corners[i], corners[(i + 1) % corners.size()]}); low != high)
      edges.insert({low, high});
  std::vector<GridLoop> strips;
  for (const auto& [low, high] : edges) {
    const GridPoint along = high - low;
    const bool upright = std::abs(along.y) > along.x;
    const GridPoint aside = upright ? GridPoint{along.y > 0 ? -1 : 1, 0} : GridPoint{0, 1};  // to the left
    strips.push_back({low - aside, high - aside, high + aside, low + aside});
  }
  return strips;
}

/// A corner that is kept, and how far at most the outline that was given strays from the edge that leads to it.
struct KeptCorner {
  Vec2 at;
  double strays = 0;
};

/// How far the edge a c, which stands for a b c, then strays at most from what was given; nothing when that is more than a
/// crumb. An antenna, which encloses nothing, counts by its width.
std::optional<double> withoutCorner(const Vec2& a, const KeptCorner& b, const KeptCorner& c, double crumb) {
  const Vec2 along = c.at - a;
  const double reach = along.norm();
  const double before = std::max(b.strays, c.strays);
  const bool antenna = before + reach <= crumb;
  if (!antenna && (!((b.at - a).dot(along) >= 0) || !((c.at - b.at).dot(along) >= 0))) return std::nullopt;
  const double strays = before + (antenna ? reach : std::abs(cross(along, Vec2(b.at - a))) / reach);
  return strays <= crumb ? std::optional(strays) : std::nullopt;
}

/// Drops the last corners while the edge to `next` can replace them.
void dropBefore(KeptCorner& next, std::vector<KeptCorner>& kept, double crumb) {
  while (kept.size() >= 2) {
    const auto strays = withoutCorner(kept[kept.size() - 2].at, kept.back(), next, crumb);
    if (!strays) return;
    next.strays = *strays;
    kept.pop_back();
  }
}

/// The same where the last corner meets the first.
void dropAtSeam(std::vector<KeptCorner>& kept, double crumb) {
  while (kept.size() >= 3) {
    if (const auto end = withoutCorner(kept[kept.size() - 2].at, kept.back(), kept.front(), crumb)) {
      kept.front().strays = *end;
      kept.pop_back();
    } else if (const auto start = withoutCorner(kept.back().at, kept.front(), kept[1], crumb)) {
      kept[1].strays = *start;
      kept.erase(kept.begin());
    } else {
      return;
    }
  }
}

/// Without collinear points and crumbs: but for antennas, what was given stays within a crumb of it. Empty when nothing of
/// any width is left.
Loop withoutCrumbs(const Loop& loop, double crumb) {
  std::vector<KeptCorner> kept;
  double skipped = 0;  // how far what was skipped lies from the last corner
  for (const Vec2& p : loop) {
    KeptCorner next{p, skipped};
    dropBefore(next, kept, crumb);
    const double step = kept.empty() ? HUGE_VAL : (kept.back().at - p).norm();
    if (step > crumb) kept.push_back(next);
    skipped = step > crumb ? 0 : std::max(next.strays, step);
  }
  dropAtSeam(kept, crumb);
  Loop corners;
  for (const KeptCorner& corner : kept) corners.push_back(corner.at);
  if (corners.size() < 3 || std::abs(signedArea(corners)) <= crumb * perimeter(corners)) return {};
  return corners;
}

/// Far from the origin the doubles of the plane lie farther apart than the grid's points.
double crumbOf(const Loop& loop, const Grid& grid) {
  double reach = 0;
  for (const Vec2& p : loop) reach = std::max(reach, grid.point(p).cwiseAbs().maxCoeff());
  return std::max(minimum, 2 * std::numeric_limits<double>::epsilon() * reach / grid.unit);
}

Loop placed(const Loop& loop, const Grid& grid) {
  Loop result;
  result.reserve(loop.size());
  for (const Vec2& p : withoutCrumbs(loop, crumbOf(loop, grid))) result.push_back(grid.point(p));
  return result;
}

}  // namespace

/// What one removal makes straight is found by stepping back.
GridLoop cleaned(const GridLoop& loop) {
  GridLoop kept;
  const auto turns = [](const GridPoint& a, const GridPoint& b, const GridPoint& c) { return cross(b - a, c - b) != 0; };
  for (const GridPoint& p : loop) {
    while (kept.size() >= 2 && !turns(kept[kept.size() - 2], kept.back(), p)) kept.pop_back();
    if (kept.empty() || kept.back() != p) kept.push_back(p);
  }
  // The seam between the last and the first point.
  for (std::size_t first = 0; kept.size() - first >= 3;) {
    const std::size_t n = kept.size();
    if (!turns(kept[n - 2], kept[n - 1], kept[first]))
      kept.pop_back();
    else if (!turns(kept[n - 1], kept[first], kept[first + 1]))
      ++first;
    else
      return {kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end()};
  }
  return {};
}

double gridUnit(const Vec2& largestSize) {
  constexpr int bits = 46;  // from the middle of a box to its sides, with one bit to spare
  int exponent = 0;
  std::frexp(std::max(largestSize.maxCoeff() / 2, 1e-200), &exponent);
  return std::ldexp(1.0, exponent - bits);
}

std::vector<GridPolygon> snapped(const Polygons& polygons, const Grid& grid) {
  std::vector<GridPolygon> result;
  for (const Polygon& polygon : polygons) {
    const GridLoop points = snapped(polygon.outer, grid);
    GridPolygon image{outlineOf(points), {}};
    if (image.outer.empty()) {
      for (GridLoop& strip : stripsAlong(points)) result.push_back({std::move(strip), {}});
      continue;
    }
    for (const Loop& hole : polygon.holes)
      if (GridLoop loop = cleaned(snapped(hole, grid)); !loop.empty()) image.holes.push_back(std::move(loop));
    result.push_back(std::move(image));
  }
  return result;
}

Polygons onPlane(const Polygons& polygons, const Grid& grid) {
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

}  // namespace blossom::planar
