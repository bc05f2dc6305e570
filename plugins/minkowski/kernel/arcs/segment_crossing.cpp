#include "kernel/arcs/segment_crossing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/numeric/box_tree.h"
#include "geometry/planar/planar.h"
#include "kernel/arcs/true_curve.h"

namespace blossom::minkowski {
namespace {

/// A segment as its curve and its box.
struct Stretch {
  const Segment* segment;
  TrueCurve curve;
  Box2 box;
};

Stretch stretchOf(const Segment& segment) {
  if (const auto* line = std::get_if<Line2>(&segment))
    return {&segment, StraightCurve{line->from, line->to}, {line->from.cwiseMin(line->to), line->from.cwiseMax(line->to)}};
  const auto& arc = std::get<Arc2>(segment);
  Stretch stretch{&segment, Circle{arc.center, arc.radius}, {}};
  stretch.box.extend(startPoint(segment));
  stretch.box.extend(endPoint(segment));
  const double first = std::min(arc.start, arc.start + arc.sweep), last = std::max(arc.start, arc.start + arc.sweep);
  for (double quarter = std::ceil(first / (std::numbers::pi / 2)); quarter * std::numbers::pi / 2 < last; ++quarter)
    stretch.box.extend(
        arc.center + arc.radius * Vec2(std::cos(quarter * std::numbers::pi / 2), std::sin(quarter * std::numbers::pi / 2)));
  return stretch;
}

/// Whether a point of its curve lies inside of a segment, farther than `touching` from its ends.
bool holds(const Stretch& stretch, const Vec2& p, double touching) {
  if ((p - startPoint(*stretch.segment)).norm() <= touching || (p - endPoint(*stretch.segment)).norm() <= touching)
    return false;
  if (const auto* line = std::get_if<Line2>(stretch.segment))
    return (p - line->from).dot(line->to - line->from) > 0 && (p - line->to).dot(line->to - line->from) < 0;
  const auto& arc = std::get<Arc2>(*stretch.segment);
  const double angle = std::atan2(p.y() - arc.center.y(), p.x() - arc.center.x());
  const double along =
      std::fmod((arc.sweep > 0 ? angle - arc.start : arc.start - angle) + 4 * std::numbers::pi, 2 * std::numbers::pi);
  return along < std::abs(arc.sweep);
}

bool crossInside(const Stretch& a, const Stretch& b, double touching) {
  const Meetings meetings = meetingsOf(a.curve, b.curve, touching);
  const auto points = meetings.points();
  // Circles and lines that meet in one point touch there; two lines cross.
  const bool lines = std::holds_alternative<StraightCurve>(a.curve) && std::holds_alternative<StraightCurve>(b.curve);
  if (points.size() == 1 && !lines) return false;
  return std::any_of(points.begin(), points.end(),
                     [&](const Vec2& p) { return holds(a, p, touching) && holds(b, p, touching); });
}

}  // namespace

bool segmentsCross(const Region& region, double touching, const Progress& progress) {
  std::vector<Stretch> stretches;
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) stretches.push_back(stretchOf(segment));
  std::vector<Box2> boxes;
  for (const Stretch& stretch : stretches) boxes.push_back(stretch.box);
  bool crossing = false;
  forEachNearPair<2>(boxes, 0, progress, [&](std::size_t i, std::size_t j) {
    crossing = crossInside(stretches[i], stretches[j], touching);
    return !crossing;
  });
  return crossing;
}

}  // namespace blossom::minkowski
