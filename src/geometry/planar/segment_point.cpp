#include "geometry/planar/segment_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

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
  constexpr double fullTurn = 2 * std::numbers::pi;
  const Vec2 out = p - arc.center;
  const double angle = std::atan2(out.y(), out.x());
  double along = std::fmod(arc.sweep > 0 ? angle - arc.start : arc.start - angle, fullTurn);
  if (along < 0) along += fullTurn;
  if (along > std::abs(arc.sweep)) return std::nullopt;
  return std::abs(out.norm() - arc.radius);
}

}  // namespace

double distanceTo(const Segment& segment, const Vec2& p) {
  const double toEnds = std::min((startPoint(segment) - p).norm(), (endPoint(segment) - p).norm());
  const auto* line = std::get_if<Line2>(&segment);
  const auto across = line ? distanceAcross(*line, p) : distanceAcross(std::get<Arc2>(segment), p);
  return across.value_or(toEnds);
}

}  // namespace blossom
