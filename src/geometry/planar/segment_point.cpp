#include "geometry/planar/segment_point.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/bspline/bspline.h"
#include "geometry/planar/angles.h"
#include "geometry/planar/planar.h"

namespace blossom {
namespace {

/// Where the foot of the perpendicular from p lies on the line.
std::optional<double> distanceAcross(const Line2& line, const Vec2& p) {
  const Vec2 along = line.to - line.from;
  const double share = (p - line.from).dot(along) / along.squaredNorm();
  if (!(share >= 0 && share <= 1)) return std::nullopt;
  return (line.from + share * along - p).norm();
}

/// Where the ray from the centre to p crosses the arc.
std::optional<double> distanceAcross(const Arc2& arc, const Vec2& p) {
  if (planar::turnAlong(arc, p) > std::abs(arc.sweep)) return std::nullopt;
  return std::abs((p - arc.center).norm() - arc.radius);
}

}  // namespace

Vec2 middleOf(const Segment& segment) {
  if (const auto* arc = std::get_if<Arc2>(&segment)) {
    const double angle = arc->start + arc->sweep / 2;
    return arc->center + arc->radius * Vec2(std::cos(angle), std::sin(angle));
  }
  if (const auto* spline = std::get_if<Spline2>(&segment))
    return point(toCurve(*spline), (spline->knots.front() + spline->knots.back()) / 2).head<2>();
  return (startPoint(segment) + endPoint(segment)) / 2;
}

double distanceTo(const Segment& segment, const Vec2& p) {
  const auto* line = std::get_if<Line2>(&segment);
  if (const auto across = line ? distanceAcross(*line, p) : distanceAcross(std::get<Arc2>(segment), p)) return *across;
  return std::min((startPoint(segment) - p).norm(), (endPoint(segment) - p).norm());
}

}  // namespace blossom
