#include "geometry/planar/fitting/segment_crossing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/numeric/box_tree.h"
#include "geometry/planar/angles.h"
#include "geometry/planar/fitting/true_curve.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/segment_box.h"

namespace blossom::planar {
namespace {

/// A segment as its curve and its box.
struct Stretch {
  const Segment* segment;
  TrueCurve curve;
  Box2 box;
};

/// Whether a point of its curve lies inside of a segment, farther than `touching` from its ends.
bool holds(const Stretch& stretch, const Vec2& p, double touching) {
  if ((p - startPoint(*stretch.segment)).norm() <= touching || (p - endPoint(*stretch.segment)).norm() <= touching)
    return false;
  if (const auto* line = std::get_if<Line2>(stretch.segment))
    return (p - line->from).dot(line->to - line->from) > 0 && (p - line->to).dot(line->to - line->from) < 0;
  const auto& arc = std::get<Arc2>(*stretch.segment);
  return turnAlong(arc, p) < std::abs(arc.sweep);
}

/// Neighbours that are nearly tangent meet near their common end as well, once more, within rounding.
double slackOf(const Stretch& a, const Stretch& b, double touching) {
  double radius = 0;
  for (const Stretch* stretch : {&a, &b})
    if (const auto* circle = std::get_if<Circle>(&stretch->curve)) radius = std::max(radius, circle->radius);
  const auto near = [&](const Vec2& p, const Vec2& q) { return (p - q).norm() <= 8 * touching; };
  const bool neighbours =
      near(endPoint(*a.segment), startPoint(*b.segment)) || near(endPoint(*b.segment), startPoint(*a.segment));
  return neighbours ? touching + std::sqrt(32 * radius * touching) : touching;
}

bool crossInside(const Stretch& a, const Stretch& b, double touching) {
  const Meetings meetings = meetingsOf(a.curve, b.curve, touching);
  const auto points = meetings.points();
  // Circles and lines that meet in one point touch there; two lines cross.
  const bool lines = std::holds_alternative<StraightCurve>(a.curve) && std::holds_alternative<StraightCurve>(b.curve);
  if (points.size() == 1 && !lines) return false;
  const double slack = points.empty() ? touching : slackOf(a, b, touching);
  return std::any_of(points.begin(), points.end(), [&](const Vec2& p) { return holds(a, p, slack) && holds(b, p, slack); });
}

/// Splines as lines within `chord`.
std::vector<Segment> segmentsOf(const Region& region, double chord) {
  std::vector<Segment> segments;
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) {
      if (!std::holds_alternative<Spline2>(segment)) {
        segments.push_back(segment);
        continue;
      }
      const std::vector<Vec2> points = flatten(segment, chord);
      for (std::size_t i = 1; i < points.size(); ++i) segments.emplace_back(Line2{points[i - 1], points[i]});
    }
  return segments;
}

}  // namespace

bool segmentsCross(const Region& region, double touching, double chord, const Progress& progress) {
  const std::vector<Segment> segments = segmentsOf(region, chord);
  std::vector<Stretch> stretches;
  stretches.reserve(segments.size());
  for (const Segment& segment : segments) stretches.push_back({&segment, trueCurveOf(segment), boxAround(segment)});
  std::vector<Box2> boxes;
  boxes.reserve(segments.size());
  for (const Stretch& stretch : stretches) boxes.push_back(stretch.box);
  bool crossing = false;
  forEachNearPair<2>(boxes, 0, progress, [&](std::size_t i, std::size_t j) {
    crossing = crossInside(stretches[i], stretches[j], touching);
    return !crossing;
  });
  return crossing;
}

}  // namespace blossom::planar
