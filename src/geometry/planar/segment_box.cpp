#include "geometry/planar/segment_box.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/planar/planar.h"
#include "geometry/planar/planar_bezier.h"

namespace blossom {
namespace {

/// The points of an arc farthest along the axes, without its ends.
void extendByQuarters(Box2& box, const Arc2& arc) {
  constexpr double quarter = std::numbers::pi / 2;
  const double first = std::min(arc.start, arc.start + arc.sweep), last = std::max(arc.start, arc.start + arc.sweep);
  for (double k = std::ceil(first / quarter); k * quarter < last; ++k)
    box.extend(Vec2(arc.center + arc.radius * Vec2(std::cos(k * quarter), std::sin(k * quarter))));
}

}  // namespace

Box2 boxAround(const Segment& segment) {
  Box2 box;
  box.extend(startPoint(segment));
  box.extend(endPoint(segment));
  if (const auto* arc = std::get_if<Arc2>(&segment)) extendByQuarters(box, *arc);
  if (const auto* spline = std::get_if<Spline2>(&segment))
    for (const Vec3& pole : spline->poles) box.extend(euclidean(pole));
  return box;
}

Box2 boxAround(std::span<const Path> paths) {
  Box2 box;
  for (const Path& path : paths)
    for (const Segment& segment : path.segments) box.extend(boxAround(segment));
  return box;
}

}  // namespace blossom
