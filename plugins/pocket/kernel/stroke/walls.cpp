#include "kernel/stroke/walls.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "core/angle.h"

namespace blossom::pocket {
namespace {

/// No point of a piece is farther from a full circle than this: distances bend by at most 1 / (distance from the centre),
/// along arcs by 1 / radius more. Only for arcs that reach on beside the piece.
double farthestFromArc(const Stroke& piece, const Stroke& arc) {
  constexpr double widestGap = fullTurn / 6;
  const double half = piece.length() / 2;
  const double centre = (piece.at(0.5) - arc.center).norm() - half;
  const bool closes = std::abs(arc.sweep) >= fullTurn - 1e-9;
  if (centre < half || (!closes && fullTurn - std::abs(arc.sweep) < widestGap)) return 1e300;
  double maximum = 0;
  for (const double share : {0.0, 0.5, 1.0}) {
    const Vec2 p = piece.at(share);
    const double along = arc.nearestShare(p);
    if (!closes && (along <= 0 || along >= 1)) return 1e300;
    maximum = std::max(maximum, std::abs((p - arc.center).norm() - arc.radius));
  }
  const double bend = 1 / centre + (piece.round ? 1 / piece.radius : 0);
  return maximum + bend * half * half / 2;
}

/// The distance to anything convex is greatest at an end of a line; an arc bends away from its chord.
double maximumAtEnds(const Stroke& piece, const Stroke& convex) {
  const double half = piece.length() / 2;
  return std::max(distance(convex, piece.from), distance(convex, piece.to)) +
         (piece.round ? half * half / (2 * piece.radius) : 0);
}

}  // namespace

/// A part of a way: how deep the tool cuts in its middle, and at most anywhere on it.
struct Walls::Interval {
  double from, to, depth, maximum;
  friend bool operator<(const Interval& a, const Interval& b) { return a.maximum < b.maximum; }
};

Walls::Walls(const Region& part, double chord) {
  std::vector<Stroke> strokes;
  for (const Path& loop : part.loops) {
    const std::vector<Stroke> some = strokesOf(loop, chord);
    strokes.insert(strokes.end(), some.begin(), some.end());
  }
  inside_ = InsideTest(strokes);
  tree_ = StrokeTree(std::move(strokes));
}

double Walls::depth(const Vec2& p, double radius) const {
  const double away = tree_.nearest(p).distance;
  return radius + (inside_(p) ? -away : away);
}

/// No point of the piece is farther from the walls than this: than from the wall next to its middle, from that one's nearest
/// point, and than the piece is long.
double Walls::farthest(const Stroke& piece) const {
  const Vec2 middle = piece.at(0.5);
  const StrokeTree::Nearest next = tree_.nearest(middle);
  const double reach = next.distance + piece.length() / 2;
  if (next.stroke >= tree_.strokes().size()) return reach;
  const Stroke& wall = tree_.strokes()[next.stroke];
  if (!wall.round) return std::min(reach, maximumAtEnds(piece, wall));
  const Vec2 foot = wall.at(wall.nearestShare(middle));
  return std::min({reach, maximumAtEnds(piece, Stroke::line(foot, foot)), farthestFromArc(piece, wall)});
}

Walls::Interval Walls::looked(const Stroke& way, double from, double to, double radius) const {
  constexpr double touching = 1e-9;
  const double middle = (from + to) / 2;
  const Stroke piece = way.part(from, to);
  if (inside_(way.at(middle)))
    if (const double away = tree_.nearest(piece, radius + 2 * touching).distance; away > touching)
      return {from, to, radius - away, radius - away};
  return {from, to, depth(way.at(middle), radius), radius + farthest(piece)};
}

std::pair<double, double> Walls::gouge(const Stroke& way, double radius, const Progress& progress) const {
  constexpr double fineness = 1e-5;
  constexpr int maximum = 100'000;
  double best = 0, share = 0.5;
  std::priority_queue<Interval> open;
  const auto add = [&](double from, double to) {
    const Interval found = looked(way, from, to, radius);
    if (found.depth > best) best = found.depth, share = (from + to) / 2;
    if (found.maximum > best + fineness) open.push(found);
  };
  for (const double end : {0.0, 1.0})
    if (const double there = depth(way.at(end), radius); there > best) best = there, share = end;
  add(0, 1);
  for (int i = 0; !open.empty() && open.top().maximum > best + fineness; ++i) {
    if (i % 64 == 0) progress.check();
    const Interval v = open.top();
    if (i == maximum) return {v.maximum, (v.from + v.to) / 2};
    open.pop();
    const double middle = (v.from + v.to) / 2;
    add(v.from, middle);
    add(middle, v.to);
  }
  return {best, share};
}

}  // namespace blossom::pocket
