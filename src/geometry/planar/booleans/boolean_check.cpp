#include "geometry/planar/booleans/boolean_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/planar/fitting/angles.h"
#include "geometry/planar/planar.h"

namespace blossom::planar {
namespace {

double distanceTo(const Line2& line, const Vec2& p) {
  const Vec2 along = line.to - line.from;
  const double squared = along.squaredNorm();
  const double share = squared > 0 ? std::clamp((p - line.from).dot(along) / squared, 0.0, 1.0) : 0;
  return (line.from + share * along - p).norm();
}

double distanceTo(const Arc2& arc, const Vec2& p) {
  const double angle = std::atan2(p.y() - arc.center.y(), p.x() - arc.center.x());
  const double along = inOneTurn(arc.sweep > 0 ? angle - arc.start : arc.start - angle);
  const double toEnds = std::min((startPoint(Segment(arc)) - p).norm(), (endPoint(Segment(arc)) - p).norm());
  if (along > std::abs(arc.sweep)) return toEnds;
  return std::min(toEnds, std::abs((p - arc.center).norm() - arc.radius));
}

double distanceTo(const Spline2&, const Vec2&) { return std::numeric_limits<double>::infinity(); }

double distanceTo(const Region& region, const Vec2& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments)
      nearest = std::min(nearest, std::visit([&](const auto& each) { return distanceTo(each, p); }, segment));
  return nearest;
}

/// On the curve, half-way between two cuts.
Vec2 middleOf(const CutSegment& each, std::size_t k) {
  const Vec2 &from = each.cuts[k], &to = each.cuts[k + 1];
  const auto* arc = std::get_if<Arc2>(&each.segment);
  if (!arc) return (from + to) / 2;
  const auto angleOf = [&](const Vec2& p) { return std::atan2(p.y() - arc->center.y(), p.x() - arc->center.x()); };
  double sweep = arc->sweep;
  if (each.cuts.size() > 2)
    sweep = sweep > 0 ? inOneTurn(angleOf(to) - angleOf(from)) : -inOneTurn(angleOf(from) - angleOf(to));
  return arc->center + arc->radius * unitAt(angleOf(from) + sweep / 2);
}

bool shouldBound(BooleanOperation operation, bool isOfFirst, bool inOther) {
  if (operation == BooleanOperation::Union) return !inOther;
  if (operation == BooleanOperation::Intersection) return inOther;
  return isOfFirst ? !inOther : inOther;
}

}  // namespace

bool boundsAsItShould(const Region& result, const BooleanOperands& operands, BooleanOperation operation, double within,
                      const Progress& progress) {
  for (const bool isOfFirst : {true, false}) {
    const Region& other = isOfFirst ? operands.second : operands.first;
    for (const CutSegment& each : isOfFirst ? operands.cut.first : operands.cut.second)
      for (std::size_t k = 0; k + 1 < each.cuts.size(); ++k) {
        progress.check();
        const Vec2 middle = middleOf(each, k);
        if (distanceTo(other, middle) <= 8 * within) continue;  // both bound, or it is too near to tell
        int winding = 0;
        for (const Path& loop : other.loops) winding += windingNumber(loop, middle);
        const double distance = distanceTo(result, middle);
        if (shouldBound(operation, isOfFirst, winding > 0) ? distance > 4 * within : distance <= within / 4) return false;
      }
  }
  return true;
}

bool isWellJoined(const Region& region, double gap, double shortest) {
  for (const Path& loop : region.loops)
    for (std::size_t i = 0; i < loop.segments.size(); ++i) {
      const Segment &segment = loop.segments[i], &next = loop.segments[(i + 1) % loop.segments.size()];
      if (!((endPoint(segment) - startPoint(next)).norm() <= gap) || !(length(segment) > shortest)) return false;
    }
  return true;
}

}  // namespace blossom::planar
