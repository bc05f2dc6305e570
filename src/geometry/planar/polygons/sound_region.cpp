#include "geometry/planar/polygons/sound_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/planar/planar.h"
#include "geometry/planar/planar_bezier.h"

namespace blossom::planar {
namespace {

template <class Is>
bool anySegment(const Region& region, Is is) {
  return std::any_of(region.loops.begin(), region.loops.end(),
                     [&](const Path& loop) { return std::any_of(loop.segments.begin(), loop.segments.end(), is); });
}

/// p goes to s p + by.
struct Similarity {
  double s = 1;
  Vec2 by = Vec2::Zero();

  Vec2 operator()(const Vec2& p) const { return s * p + by; }
  Segment operator()(const Line2& line) const { return Line2{(*this)(line.from), (*this)(line.to)}; }
  Segment operator()(const Arc2& arc) const {
    return Arc2{(*this)(arc.center), std::abs(s) * arc.radius, s > 0 ? arc.start : arc.start + std::numbers::pi, arc.sweep};
  }
  Segment operator()(const Spline2& spline) const {
    Spline2 image = spline;
    for (Vec3& pole : image.poles) pole.head<2>() = s * pole.head<2>() + pole.z() * by;
    return image;
  }
};

SoundRegion mapped(const SoundRegion& shape, const Similarity& map) {
  SoundRegion image{shape.region, std::abs(map.s) * shape.tolerance, shape.plain};
  for (Path& loop : image.region.loops)
    for (Segment& segment : loop.segments) segment = std::visit(map, segment);
  return image;
}

/// Unit directions at the start and the end of a line or an arc.
std::pair<Vec2, Vec2> directionsOf(const Segment& segment) {
  if (const auto* line = std::get_if<Line2>(&segment)) {
    const Vec2 along = (line->to - line->from).normalized();
    return {along, along};
  }
  const auto& arc = std::get<Arc2>(segment);
  const double sign = arc.sweep > 0 ? 1 : -1;
  const auto along = [&](double angle) { return Vec2(sign * Vec2(-std::sin(angle), std::cos(angle))); };
  return {along(arc.start), along(arc.start + arc.sweep)};
}

Path closedPath(const Loop& loop) {
  Path path;
  path.closed = true;
  for (std::size_t i = 0; i < loop.size(); ++i) path.segments.emplace_back(Line2{loop[i], loop[(i + 1) % loop.size()]});
  return path;
}

void extendLoosely(Box2& box, const Segment& segment) {
  box.extend(startPoint(segment));
  box.extend(endPoint(segment));
  if (const auto* arc = std::get_if<Arc2>(&segment)) {
    box.extend(Vec2(arc->center + Vec2::Constant(arc->radius)));
    box.extend(Vec2(arc->center - Vec2::Constant(arc->radius)));
  }
  if (const auto* spline = std::get_if<Spline2>(&segment))
    for (const Vec3& pole : spline->poles) box.extend(euclidean(pole));
}

}  // namespace

bool hasCurves(const Region& region) {
  return anySegment(region, [](const Segment& segment) { return !std::holds_alternative<Line2>(segment); });
}

bool hasSplines(const Region& region) {
  return anySegment(region, [](const Segment& segment) { return std::holds_alternative<Spline2>(segment); });
}

SoundRegion scaled(const SoundRegion& shape, double s) {
  SoundRegion image = mapped(shape, {.s = s});
  if (s > 0) {
    image.kept = shape.kept;
    image.factor = s * shape.factor;
  }
  return image;
}

SoundRegion translated(const SoundRegion& shape, const Vec2& by) { return mapped(shape, {.by = by}); }

bool isConvex(const SoundRegion& shape) {
  if (shape.region.loops.size() != 1) return false;
  if (hasSplines(shape.region)) return isConvex(Polygons{{flatten(shape.region.loops.front(), shape.tolerance), {}}});
  const std::vector<Segment>& segments = shape.region.loops.front().segments;
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (const auto* arc = std::get_if<Arc2>(&segments[i]); arc && arc->sweep < 0) return false;
    const Vec2 in = directionsOf(segments[i]).second, out = directionsOf(segments[(i + 1) % segments.size()]).first;
    const double turn = cross(in, out);
    if (turn < -rounding || (turn <= rounding && in.dot(out) < 0)) return false;  // also a cusp
  }
  return true;
}

Box2 looseBox(std::span<const Path> paths) {
  Box2 box;
  for (const Path& path : paths)
    for (const Segment& segment : path.segments) extendLoosely(box, segment);
  return box;
}

Polygons toPolygons(const SoundRegion& shape) {
  Polygons polygons;
  for (const Path& path : shape.region.loops) {
    Loop loop;
    loop.reserve(path.segments.size());
    for (const Segment& segment : path.segments) loop.push_back(startPoint(segment));
    if (polygons.empty() || signedArea(loop) > 0)
      polygons.push_back({std::move(loop), {}});
    else
      polygons.back().holes.push_back(std::move(loop));
  }
  return polygons;
}

Region toRegion(const Polygons& polygons) {
  Region region;
  for (const Polygon& polygon : polygons) {
    region.loops.push_back(closedPath(polygon.outer));
    for (const Loop& hole : polygon.holes) region.loops.push_back(closedPath(hole));
  }
  return region;
}

}  // namespace blossom::planar
