#include "geometry/planar/sums/shared_sides.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "geometry/numeric/box_tree.h"
#include "geometry/numeric/union_find.h"
#include "geometry/planar/angles.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/polygons/sound_region.h"
#include "geometry/planar/segment_box.h"
#include "geometry/planar/segment_point.h"
#include "geometry/planar/sums/loop_senses.h"
#include "geometry/planar/sums/shared_splines.h"

namespace blossom::planar {
namespace {

/// A segment of a loop, or a part of one.
struct BoundarySide {
  Segment segment;
  std::size_t loop = 0;
  std::size_t next = 0;           ///< the side after it in its loop
  std::vector<double> cuts = {};  ///< shares of the segment, where others on it begin or end
  bool isGone = false;
};

bool isNear(const Vec2& p, const Vec2& q, double rounding) { return (p - q).norm() <= rounding; }

/// The share of a segment at which a point of it lies, if not at an end.
std::optional<double> insideAt(const Line2& line, const Vec2& p, double rounding) {
  const Vec2 along = line.to - line.from;
  const double size = along.norm(), way = (p - line.from).dot(along) / size;
  if (way <= rounding || way >= size - rounding) return std::nullopt;
  return way / size;
}
std::optional<double> insideAt(const Arc2& arc, const Vec2& p, double rounding) {
  const double turn = turnAlong(arc, p), least = rounding / arc.radius;
  if (turn <= least || turn >= std::abs(arc.sweep) - least) return std::nullopt;
  return turn / std::abs(arc.sweep);
}

std::optional<double> insideAt(const Spline2& spline, const Vec2& p, double rounding) {
  if (!comeNear(boxAround(spline), Box2(p), rounding)) return std::nullopt;
  if (isNear(startPoint(spline), p, rounding) || isNear(endPoint(spline), p, rounding)) return std::nullopt;
  return shareAt(spline, p, rounding);
}

bool runOnOneCurve(const Line2& a, const Line2& b, double rounding) {
  const Vec2 along = a.to - a.from;
  const double size = along.norm();
  const auto off = [&](const Vec2& p) { return std::abs(cross(along, p - a.from)); };
  return size > rounding && along.dot(b.to - b.from) < 0 && off(b.from) <= rounding * size && off(b.to) <= rounding * size;
}
double lengthOf(const Arc2& arc) { return arc.radius * std::abs(arc.sweep); }

/// Measured at the points of the shorter one: of a shallow arc, the centre is known far less well.
bool runOnOneCurve(const Arc2& a, const Arc2& b, double rounding) {
  if (a.sweep * b.sweep >= 0) return false;
  const bool isFirstShorter = lengthOf(a) < lengthOf(b);
  const Arc2 &shorter = isFirstShorter ? a : b, &longer = isFirstShorter ? b : a;
  const auto isOn = [&](const Vec2& p) { return std::abs((p - longer.center).norm() - longer.radius) <= rounding; };
  return isOn(startPoint(shorter)) && isOn(middleOf(shorter)) && isOn(endPoint(shorter));
}

/// Splines that only meet are cut in vain.
bool runOnOneCurve(const Spline2&, const Spline2&, double) { return true; }

/// Cuts both where the other one begins and ends on it. @returns whether there is such a place, or both have the same ends
template <class Curve>
bool cutByEachOther(const Curve& a, const Curve& b, double rounding, BoundarySide& sideA, BoundarySide& sideB) {
  if (!runOnOneCurve(a, b, rounding)) return false;
  const auto cut = [&](const Curve& curve, const Segment& other, BoundarySide& side) {
    bool any = false;
    for (const Vec2& end : {startPoint(other), endPoint(other)})
      if (const auto share = insideAt(curve, end, rounding)) {
        side.cuts.push_back(*share);
        any = true;
      }
    return any;
  };
  const bool first = cut(a, sideB.segment, sideA), second = cut(b, sideA.segment, sideB);
  return first || second ||
         (isNear(startPoint(sideA.segment), endPoint(sideB.segment), rounding) &&
          isNear(endPoint(sideA.segment), startPoint(sideB.segment), rounding));
}

double extentOf(const Segment& segment) { return boxAround(segment).sizes().norm(); }

/// Both ways of one curve, from end to end.
bool areOpposite(const Segment& a, const Segment& b, double mostRounding) {
  if (a.index() != b.index()) return false;
  // Sides that follow each other are no two ways of one, however short they are.
  const double rounding = std::min(mostRounding, std::min(extentOf(a), extentOf(b)) / 4);
  if (!isNear(startPoint(a), endPoint(b), rounding) || !isNear(endPoint(a), startPoint(b), rounding)) return false;
  if (std::holds_alternative<Line2>(a)) return true;
  if (const auto* arc = std::get_if<Arc2>(&a)) {
    const Arc2& other = std::get<Arc2>(b);
    return runOnOneCurve(*arc, other, rounding) && std::abs(lengthOf(*arc) - lengthOf(other)) <= 4 * rounding;
  }
  return runTogether(std::get<Spline2>(a), std::get<Spline2>(reversed(b)), rounding);
}

std::vector<Box2> boxesOf(const std::vector<BoundarySide>& sides) {
  std::vector<Box2> boxes;
  boxes.reserve(sides.size());
  for (const BoundarySide& side : sides) boxes.push_back(boxAround(side.segment));
  return boxes;
}

std::vector<BoundarySide> sidesOf(const Region& region) {
  std::vector<BoundarySide> sides;
  for (std::size_t loop = 0; loop < region.loops.size(); ++loop) {
    const std::size_t first = sides.size();
    for (const Segment& segment : region.loops[loop].segments) sides.push_back({segment, loop, sides.size() + 1});
    if (sides.size() > first) sides.back().next = first;
  }
  return sides;
}

enum class Shared { Curves, Any };  ///< what has to be among the sides that go

/// Marks the cuts. @returns whether something wanted may be shared
bool cutSides(std::vector<BoundarySide>& sides, Shared wanted, double rounding, const Progress& progress) {
  bool shared = false;
  forEachNearPair<2>(boxesOf(sides), rounding, progress, [&](std::size_t i, std::size_t j) {
    BoundarySide &a = sides[i], &b = sides[j];
    if (a.segment.index() != b.segment.index()) return true;
    if (const auto* line = std::get_if<Line2>(&a.segment))
      shared = (cutByEachOther(*line, std::get<Line2>(b.segment), rounding, a, b) && wanted == Shared::Any) || shared;
    else if (const auto* arc = std::get_if<Arc2>(&a.segment))
      shared = cutByEachOther(*arc, std::get<Arc2>(b.segment), rounding, a, b) || shared;
    else
      shared = cutByEachOther(std::get<Spline2>(a.segment), std::get<Spline2>(b.segment), rounding, a, b) || shared;
    return true;
  });
  return shared;
}

Segment partOf(const Segment& segment, double from, double to) {
  if (const auto* line = std::get_if<Line2>(&segment)) {
    const auto at = [&](double share) { return share == 1 ? line->to : Vec2(line->from + share * (line->to - line->from)); };
    return Line2{at(from), at(to)};
  }
  if (const auto* spline = std::get_if<Spline2>(&segment)) return splinePart(*spline, from, to);
  Arc2 arc = std::get<Arc2>(segment);
  arc.start += from * arc.sweep;
  arc.sweep *= to - from;
  return arc;
}

/// In order, those within rounding of each other as one: sides of several neighbours end there.
std::vector<double> cutsOf(const BoundarySide& side, double rounding) {
  std::vector<double> cuts = side.cuts;
  std::sort(cuts.begin(), cuts.end());
  const double near = rounding / std::max(extentOf(side.segment), rounding);
  cuts.erase(std::unique(cuts.begin(), cuts.end(), [&](double a, double b) { return b - a < near; }), cuts.end());
  return cuts;
}

std::vector<BoundarySide> divided(const std::vector<BoundarySide>& sides, double rounding) {
  std::vector<BoundarySide> parts;
  std::vector<std::size_t> firstPart;
  for (const BoundarySide& side : sides) {
    firstPart.push_back(parts.size());
    std::vector<double> ends = cutsOf(side, rounding);
    if (ends.empty()) {
      parts.push_back({side.segment, side.loop});
      continue;
    }
    ends.push_back(1);
    double from = 0;
    for (const double to : ends) {
      parts.push_back({partOf(side.segment, from, to), side.loop});
      from = to;
    }
  }
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const std::size_t last = (k + 1 < sides.size() ? firstPart[k + 1] : parts.size()) - 1;
    for (std::size_t p = firstPart[k]; p < last; ++p) parts[p].next = p + 1;
    parts[last].next = firstPart[sides[k].next];
  }
  return parts;
}

/// Takes opposite sides away. @returns the places where sides begin, those that come together as one
UnionFind cancelOpposites(std::vector<BoundarySide>& sides, double rounding, const Progress& progress) {
  UnionFind places(sides.size());
  forEachNearPair<2>(boxesOf(sides), rounding, progress, [&](std::size_t i, std::size_t j) {
    BoundarySide &a = sides[i], &b = sides[j];
    if (a.isGone || b.isGone || !areOpposite(a.segment, b.segment, 4 * rounding)) return true;
    a.isGone = b.isGone = true;
    places.unite(i, b.next);
    places.unite(a.next, j);
    return true;
  });
  return places;
}

/// Angle from the first direction to the second one, clockwise, above 0.
double clockwise(const Vec2& from, const Vec2& to) {
  const double turn = inOneTurn(-std::atan2(cross(from, to), from.dot(to)));
  return turn > 0 ? turn : fullTurn;
}

/// The way on at the end of each side that stays: the first one clockwise from the way back, which bounds what lies to the
/// left. Nothing where two sides go on the same way.
std::optional<std::vector<std::size_t>> waysOn(const std::vector<BoundarySide>& sides, UnionFind& places, double size) {
  std::map<std::size_t, std::vector<std::size_t>> leaving;  // by place
  for (std::size_t k = 0; k < sides.size(); ++k)
    if (!sides[k].isGone) leaving[places.find(k)].push_back(k);
  const double chord = 1e-3 * size;
  std::vector<std::size_t> on(sides.size(), sides.size());
  std::vector<bool> taken(sides.size(), false);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    if (sides[k].isGone) continue;
    const std::vector<std::size_t>& ways = leaving[places.find(sides[k].next)];
    if (ways.empty()) return std::nullopt;
    on[k] = ways.front();
    if (ways.size() > 1) {
      const std::vector<Vec2> arriving = flatten(sides[k].segment, chord);
      const Vec2 back = arriving[arriving.size() - 2] - arriving.back();
      const auto turnTo = [&](std::size_t way) {
        const std::vector<Vec2> points = flatten(sides[way].segment, chord);
        return clockwise(back, points[1] - points[0]);
      };
      on[k] =
          *std::min_element(ways.begin(), ways.end(), [&](std::size_t a, std::size_t b) { return turnTo(a) < turnTo(b); });
    }
    if (taken[on[k]]) return std::nullopt;
    taken[on[k]] = true;
  }
  return on;
}

struct JoinedLoops {
  std::vector<Path> loops;
  std::vector<std::size_t> isNew;  ///< those that were not loops before
};

JoinedLoops joinedLoops(const std::vector<BoundarySide>& sides, const std::vector<std::size_t>& on) {
  JoinedLoops joined;
  std::vector<bool> used(sides.size(), false);
  for (std::size_t first = 0; first < sides.size(); ++first) {
    if (sides[first].isGone || used[first]) continue;
    Path& loop = joined.loops.emplace_back();
    loop.closed = true;
    bool isNew = false;
    for (std::size_t k = first; !used[k]; k = on[k]) {
      used[k] = true;
      loop.segments.push_back(sides[k].segment);
      isNew = isNew || on[k] != sides[k].next;
    }
    if (isNew) joined.isNew.push_back(joined.loops.size() - 1);
  }
  return joined;
}

/// A place on each loop that is gone as a whole.
std::vector<Vec2> placesOnGoneLoops(const std::vector<BoundarySide>& sides, std::size_t loops) {
  std::vector<bool> stays(loops, false), seen(loops, false);
  for (const BoundarySide& side : sides)
    if (!side.isGone) stays[side.loop] = true;
  std::vector<Vec2> places;
  for (const BoundarySide& side : sides)
    if (!stays[side.loop] && !seen[side.loop]) {
      seen[side.loop] = true;
      places.push_back(middleOf(side.segment));
    }
  return places;
}

/// Whether new loops bound something once: a loop that has come apart may enclose something twice. That is told of it as it
/// was drawn.
bool boundOnce(const JoinedLoops& joined, const LoopSenses& senses, const Progress& progress) {
  return std::all_of(joined.isNew.begin(), joined.isNew.end(), [&](std::size_t loop) {
    progress.check();
    return senses.bounds(joined.loops[loop]);
  });
}

/// A place where nothing is left of a loop that is gone: it was drawn twice, and one of both counts as a hole in the other.
std::optional<Vec2> placeOfTwice(const std::vector<BoundarySide>& sides, std::size_t loops, const LoopSenses& senses,
                                 const Progress& progress) {
  for (const Vec2& place : placesOnGoneLoops(sides, loops)) {
    progress.check();
    if (!senses.holds(place)) return place;
  }
  return std::nullopt;
}

SharedSides sharedSides(const Region& region, Shared wanted, double size, double rounding, const Progress& progress) {
  std::vector<BoundarySide> sides = sidesOf(region);
  if (!cutSides(sides, wanted, rounding, progress)) return {};
  sides = divided(sides, rounding);
  UnionFind places = cancelOpposites(sides, rounding, progress);
  const auto isWanted = [&](const BoundarySide& side) {
    return side.isGone && (wanted == Shared::Any || !std::holds_alternative<Line2>(side.segment));
  };
  if (std::none_of(sides.begin(), sides.end(), isWanted)) return {};
  const auto on = waysOn(sides, places, size);
  if (!on) return {};
  JoinedLoops joined = joinedLoops(sides, *on);
  const LoopSenses senses(joined.loops, progress);
  if (const auto twice = placeOfTwice(sides, region.loops.size(), senses, progress)) return {{}, twice};
  if (joined.loops.empty() || !boundOnce(joined, senses, progress)) return {};
  return {Region{std::move(joined.loops)}, {}};
}

}  // namespace

SharedSides withoutSharedSides(const Region& region, double tolerance, const Progress& progress) {
  if (!hasCurves(region)) return {};
  const double size = boxAround(region.loops).sizes().maxCoeff();
  const Box2 withCenters = looseBox(region.loops);  // shallow arcs have theirs far away
  const double farthest = std::max(withCenters.min().cwiseAbs().maxCoeff(), withCenters.max().cwiseAbs().maxCoeff());
  const double ofNumbers = std::max(1e-9 * size, std::min(1e-14 * farthest, 0.1 * tolerance));
  // Files with six decimals round bulges, too.
  const double ofFiles = std::max(ofNumbers, std::min(1e-6 * size, 0.1 * tolerance));
  SharedSides found = sharedSides(region, Shared::Curves, size, ofFiles, progress);
  if (found.without || found.drawnTwice) return found;
  return sharedSides(region, Shared::Any, size, ofNumbers, progress);
}

}  // namespace blossom::planar
