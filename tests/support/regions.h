#pragma once
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "geometry/planar/planar.h"

namespace blossom::test {

inline Path polygonPath(const std::vector<Vec2>& points) {
  Path path;
  path.closed = true;
  for (std::size_t i = 0; i < points.size(); ++i)
    path.segments.emplace_back(Line2{points[i], points[(i + 1) % points.size()]});
  return path;
}

inline Region polygonRegion(const std::vector<Vec2>& points) { return {{polygonPath(points)}}; }

inline Path rectanglePath(const Vec2& low, const Vec2& high) {
  return polygonPath({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
}

/// From one point to another one, turning by the sweep.
inline Arc2 arcBetween(const Vec2& from, const Vec2& to, double sweep) {
  const Vec2 half = (to - from) / 2, center = from + half + Vec2(-half.y(), half.x()) / std::tan(sweep / 2);
  const Vec2 out = from - center;
  return {center, out.norm(), std::atan2(out.y(), out.x()), sweep};
}

/// The farthest that one side ends from the beginning of the next.
inline double largestGap(const Region& region) {
  double gap = 0;
  for (const Path& loop : region.loops)
    for (std::size_t i = 0; i < loop.segments.size(); ++i)
      gap = std::max(gap, (endPoint(loop.segments[i]) - startPoint(loop.segments[(i + 1) % loop.segments.size()])).norm());
  return gap;
}

inline Region rectangleRegion(const Vec2& low, const Vec2& high) { return {{rectanglePath(low, high)}}; }

inline Region circleRegion(double radius, const Vec2& center = Vec2::Zero()) {
  Path path;
  path.closed = true;
  path.segments.emplace_back(Arc2{center, radius, 0, 2 * std::numbers::pi});
  return {{path}};
}

/// A circle drawn as files do: in several arcs.
inline Path circleInArcs(double radius, int arcs, const Vec2& center = Vec2::Zero(), double start = 0) {
  Path path;
  path.closed = true;
  const double sweep = 2 * std::numbers::pi / arcs;
  for (int k = 0; k < arcs; ++k) path.segments.emplace_back(Arc2{center, radius, start + k * sweep, sweep});
  return path;
}

inline Region ellipseRegion(double a, double b) {
  Path path;
  path.closed = true;
  path.segments.emplace_back(ellipticArc({0, 0}, {a, 0}, b / a, 0, 2 * std::numbers::pi));
  return {{path}};
}

/// A polygon around `center` that is seen from there as a whole, with corners at random distances up to `reach`.
inline std::vector<Vec2> spikyPoints(std::mt19937_64& random, const Vec2& center, double reach, int corners) {
  std::uniform_real_distribution<double> distance(0.25, 1);
  std::vector<Vec2> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.8 * distance(random)) / corners;
    points.push_back(center + reach * distance(random) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

/// Up to three spiky parts apart from one another, some of them with a spiky hole.
inline Region randomRegion(std::mt19937_64& random, double reach) {
  std::uniform_int_distribution<int> parts(1, 3), corners(3, 9), coin(0, 1);
  Region region;
  const int count = parts(random);
  for (int k = 0; k < count; ++k) {
    const Vec2 center(2.2 * reach * k, reach * 0.3 * (coin(random) - 0.5));
    std::vector<Vec2> outer = spikyPoints(random, center, reach, corners(random) + 2);
    if (coin(random) == 1) {
      for (Vec2& p : outer) p = center + (p - center).normalized() * std::max((p - center).norm(), 0.85 * reach);
      if (outer.size() > 5) {  // a hole well inside: the outline's chords stay beyond 0.4 of its reach
        std::vector<Vec2> hole = spikyPoints(random, center, 0.33 * reach, corners(random));
        std::reverse(hole.begin(), hole.end());
        region.loops.push_back(polygonPath(hole));
      }
    }
    region.loops.push_back(polygonPath(outer));
  }
  return region;
}

/// Unit squares of a lattice by their lower left corners.
using Cells = std::set<std::pair<int, int>>;

/// Random squares: parts that touch in corners, holes of a single square, holes as large as what is put into them.
inline Cells randomCells(std::mt19937_64& random, int width, int height, double share) {
  std::bernoulli_distribution taken(share);
  Cells cells{{0, 0}};
  for (int x = 0; x < width; ++x)
    for (int y = 0; y < height; ++y)
      if (taken(random)) cells.insert({x, y});
  return cells;
}

/// The area of lattice squares; loops touch in corners, where the boundary keeps to its own square.
inline Region cellRegion(const Cells& cells) {
  using Corner = std::pair<int, int>;
  std::set<std::pair<Corner, Corner>> edges;  // squares on their left
  const auto add = [&](Corner from, Corner to) {
    if (edges.erase({to, from}) == 0) edges.insert({from, to});
  };
  for (const auto& [x, y] : cells) {
    add({x, y}, {x + 1, y});
    add({x + 1, y}, {x + 1, y + 1});
    add({x + 1, y + 1}, {x, y + 1});
    add({x, y + 1}, {x, y});
  }
  Region region;
  while (!edges.empty()) {
    const Corner start = edges.begin()->first;
    Corner at = edges.begin()->second;
    std::pair<int, int> along{at.first - start.first, at.second - start.second};
    edges.erase(edges.begin());
    std::vector<Vec2> points{{start.first, start.second}};
    while (at != start) {
      const auto [dx, dy] = along;
      for (const auto& turn : {std::pair{-dy, dx}, std::pair{dx, dy}, std::pair{dy, -dx}}) {  // leftmost first
        const Corner next{at.first + turn.first, at.second + turn.second};
        if (edges.erase({at, next}) == 0) continue;
        if (turn != along) points.emplace_back(at.first, at.second);
        along = turn;
        at = next;
        break;
      }
    }
    region.loops.push_back(polygonPath(points));
  }
  return region;
}

}  // namespace blossom::test
