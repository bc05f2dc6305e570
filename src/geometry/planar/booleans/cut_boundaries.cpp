#include "geometry/planar/booleans/cut_boundaries.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "geometry/numeric/box_tree.h"
#include "geometry/planar/angles.h"
#include "geometry/planar/booleans/point_welder.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/segment_box.h"

namespace blossom::planar {
namespace {

/// Angle from the start of an arc to a point, in the direction of the arc; a little below 0 just before the start.
double angleAlong(const Arc2& arc, const Vec2& p, double slack) {
  const double along = turnAlong(arc, p);
  return along > fullTurn - slack ? along - fullTurn : along;
}

/// Length along a segment up to the point on its curve nearest to p.
double lengthAlong(const Segment& segment, const Vec2& p, double within) {
  if (const auto* line = std::get_if<Line2>(&segment)) return (p - line->from).dot((line->to - line->from).normalized());
  const auto& arc = std::get<Arc2>(segment);
  return arc.radius * angleAlong(arc, p, 2 * within / arc.radius);
}

bool holds(const Segment& segment, const Vec2& p, double within) {
  const double along = lengthAlong(segment, p, within);
  return along >= -within && along <= length(segment) + within;
}

/// Sine of the angle between two curves at a point of both.
double sineBetween(const TrueCurve& a, const TrueCurve& b, const Vec2& p) {
  const auto along = [&](const TrueCurve& curve) -> Vec2 {
    if (const auto* line = std::get_if<StraightCurve>(&curve)) return (line->to - line->from).normalized();
    const Vec2 out = (p - std::get<Circle>(curve).centre).normalized();
    return {-out.y(), out.x()};
  };
  return std::abs(cross(along(a), along(b)));
}

/// Each ends where the next one begins.
std::vector<CutSegment> segmentsOf(const Region& region, double within) {
  std::vector<CutSegment> segments;
  for (std::size_t k = 0; k < region.loops.size(); ++k) {
    const std::size_t first = segments.size();
    for (const Segment& segment : region.loops[k].segments)
      if (length(segment) > within) segments.push_back({segment, trueCurveOf(segment), {startPoint(segment)}, k});
    for (std::size_t i = first; i < segments.size(); ++i)
      segments[i].cuts.push_back(segments[i + 1 < segments.size() ? i + 1 : first].cuts.front());
  }
  return segments;
}

class Cutter {
 public:
  Cutter(const Region& a, const Region& b, double within)
      : cut_{segmentsOf(a, within), segmentsOf(b, within), {}}, within_(within), places_(within) {}

  std::optional<CutBoundaries> run(const Progress& progress) {
    for (std::vector<CutSegment>* side : {&cut_.first, &cut_.second})
      for (CutSegment& each : *side) {
        if (!((each.cuts[1] - endPoint(each.segment)).norm() <= 2 * within_)) return std::nullopt;
        each.cuts = {places_.welded(each.cuts[0]), each.cuts[1]};
      }
    endWhereNextBegin(cut_.first);
    endWhereNextBegin(cut_.second);
    bool clear = true;
    const std::size_t count = cut_.first.size();
    forEachNearPair<2>(boxes(), 2 * within_, progress, [&](std::size_t i, std::size_t j) {
      if ((i < count) == (j < count)) return true;
      clear = cutEachOther(cut_.first[std::min(i, j)], cut_.second[std::max(i, j) - count]);
      return clear;
    });
    if (!clear) return std::nullopt;
    for (std::vector<CutSegment>* side : {&cut_.first, &cut_.second})
      for (CutSegment& each : *side) sortCuts(each);
    return std::move(cut_);
  }

 private:
  /// By the starts as they were welded: welded anew, an end might find a nearer point than the start did.
  static void endWhereNextBegin(std::vector<CutSegment>& side) {
    for (std::size_t first = 0; first < side.size();) {
      std::size_t last = first;
      while (last + 1 < side.size() && side[last + 1].loop == side[first].loop) ++last;
      for (std::size_t i = first; i <= last; ++i) side[i].cuts[1] = side[i < last ? i + 1 : first].cuts[0];
      first = last + 1;
    }
  }

  [[nodiscard]] std::vector<Box2> boxes() const {
    std::vector<Box2> boxes;
    for (const std::vector<CutSegment>* side : {&cut_.first, &cut_.second})
      for (const CutSegment& each : *side) boxes.push_back(boxAround(each.segment));
    return boxes;
  }

  /// False where rounding decides.
  bool cutEachOther(CutSegment& a, CutSegment& b) {
    if (sameCurve(a.curve, b.curve, within_)) {
      cutAtEnds(a, b);
      cutAtEnds(b, a);
      return true;
    }
    const Meetings meetings = meetingsOf(a.curve, b.curve, 4 * within_);
    const auto points = meetings.points();
    const bool lines = std::holds_alternative<Line2>(a.segment) && std::holds_alternative<Line2>(b.segment);
    for (const Vec2& p : points) {
      if (!holds(a.segment, p, within_) || !holds(b.segment, p, within_)) continue;
      constexpr double blunt = 1e-7;  // radians
      if (lines && sineBetween(a.curve, b.curve, p) < blunt) return false;
      const bool crosses = (lines || points.size() == 2) && !isEnd(a, p) && !isEnd(b, p);
      const Vec2 place = places_.welded(p);
      a.cuts.push_back(place);
      b.cuts.push_back(place);
      if (crosses) cut_.crossings.push_back(place);
    }
    return true;
  }

  void cutAtEnds(CutSegment& a, const CutSegment& b) const {
    for (const Vec2& end : {b.cuts[0], b.cuts[1]})
      if (holds(a.segment, end, within_)) a.cuts.push_back(end);
  }

  [[nodiscard]] bool isEnd(const CutSegment& each, const Vec2& p) const {
    return (p - each.cuts[0]).norm() <= 2 * within_ || (p - each.cuts[1]).norm() <= 2 * within_;
  }

  void sortCuts(CutSegment& each) const {
    const Vec2 from = each.cuts[0], to = each.cuts[1];
    std::vector<Vec2> inner(each.cuts.begin() + 2, each.cuts.end());
    std::erase_if(inner, [&](const Vec2& p) { return p == from || p == to; });
    std::sort(inner.begin(), inner.end(), [&](const Vec2& p, const Vec2& q) {
      return lengthAlong(each.segment, p, within_) < lengthAlong(each.segment, q, within_);
    });
    inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
    each.cuts = {from};
    each.cuts.insert(each.cuts.end(), inner.begin(), inner.end());
    each.cuts.push_back(to);
  }

  CutBoundaries cut_;
  double within_;
  PointWelder places_;
};

}  // namespace

double CutSegment::sweepOf(std::size_t piece) const {
  const auto& arc = std::get<Arc2>(segment);
  if (pieces() == 1) return arc.sweep;
  const Vec2 from = cuts[piece] - arc.center, to = cuts[piece + 1] - arc.center;
  const double turn = inOneTurn(std::atan2(cross(from, to), from.dot(to)));
  return arc.sweep > 0 ? turn : turn - fullTurn;
}

Vec2 CutSegment::pointOf(std::size_t piece, double share) const {
  const Vec2 &from = cuts[piece], &to = cuts[piece + 1];
  const auto* arc = std::get_if<Arc2>(&segment);
  if (!arc) return from + share * (to - from);
  const double start = std::atan2(from.y() - arc->center.y(), from.x() - arc->center.x());
  return arc->center + arc->radius * unitAt(start + share * sweepOf(piece));
}

std::optional<CutBoundaries> cutBoundaries(const Region& a, const Region& b, double within, const Progress& progress) {
  return Cutter(a, b, within).run(progress);
}

}  // namespace blossom::planar
