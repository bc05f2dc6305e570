#pragma once
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/angle.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/region.h"

/// Slots of even width along arcs and lines that follow one another smoothly, or along waves.
namespace blossom::test {

/// A point with a direction.
struct Heading {
  Vec2 at = Vec2::Zero();
  double angle = 0;

  [[nodiscard]] Vec2 along() const { return {std::cos(angle), std::sin(angle)}; }
  /// To the left; below 0: to the right.
  [[nodiscard]] Vec2 beside(double distance) const { return at + distance * Vec2(-std::sin(angle), std::cos(angle)); }
};

struct BentSlot {
  Region part;
  double width = 0, length = 0;
  bool hasRoundEnds = false;
  std::string told;       ///< for messages
  Path right;             ///< its walls, from the start to the end
  Path left;              ///< from the end to the start
  Heading start, finish;  ///< of its middle
};

inline void addWall(const Path& wall, Path& loop) {
  loop.segments.insert(loop.segments.end(), wall.segments.begin(), wall.segments.end());
}

/// Closes the walls by half circles or straight lines.
inline void closeEnds(BentSlot& slot) {
  const double half = slot.width / 2;
  Path loop;
  loop.closed = true;
  addWall(slot.right, loop);
  const auto end = [&](const Heading& heading, double turned) {
    const double angle = heading.angle + turned;
    if (slot.hasRoundEnds)
      loop.segments.emplace_back(Arc2{heading.at, half, angle - fullTurn / 4, fullTurn / 2});
    else
      loop.segments.emplace_back(Line2{Heading{heading.at, angle}.beside(-half), Heading{heading.at, angle}.beside(half)});
  };
  end(slot.finish, 0);
  addWall(slot.left, loop);
  end(slot.start, fullTurn / 2);
  slot.part.loops = {loop};
}

/// Its middle turns left and right, up to `steepest` radians from x, so that it does not meet itself; it is at least
/// twice as long as wide.
inline BentSlot arcSlot(std::mt19937_64& random, double width, double steepest = 1.3) {
  std::uniform_real_distribution<double> unit(0, 1);
  BentSlot slot;
  slot.width = width;
  slot.hasRoundEnds = unit(random) < 0.5;
  const double half = width / 2;
  Heading at{{10 * unit(random), 10 * unit(random)}, steepest * (2 * unit(random) - 1)};
  slot.start = at;
  const int pieces = 1 + static_cast<int>(6 * unit(random));
  for (int i = 0; i < pieces || slot.length < 2 * width; ++i) {
    Heading next = at;
    Segment right, left;  // both forwards
    if (i > 0 && unit(random) < 0.3) {
      next.at += width * (0.5 + 5 * unit(random)) * at.along();
      right = Line2{at.beside(-half), next.beside(-half)};
      left = Line2{next.beside(half), at.beside(half)};
      slot.length += (next.at - at.at).norm();
    } else {
      next.angle = steepest * (2 * unit(random) - 1);
      const double sweep = next.angle - at.angle, side = sweep < 0 ? -1 : 1;
      const double radius = width * (0.62 + 5 * unit(random));
      const Vec2 center = at.beside(side * radius);
      next.at = center + side * (next.at - next.beside(radius));
      const double begin = at.angle - side * fullTurn / 4;
      right = Arc2{center, radius + side * half, begin, sweep};
      left = Arc2{center, radius - side * half, begin + sweep, -sweep};
      slot.length += radius * std::abs(sweep);
    }
    slot.right.segments.push_back(right);
    slot.left.segments.insert(slot.left.segments.begin(), left);
    at = next;
  }
  slot.finish = at;
  slot.told = fmt::format("{} arcs and lines, {:.17g} wide, {} ends", pieces, width, slot.hasRoundEnds ? "round" : "square");
  closeEnds(slot);
  return slot;
}

/// A cubic B-spline of Bezier pieces through points with given derivatives.
inline Spline2 hermiteSpline(const std::vector<Vec2>& points, const std::vector<Vec2>& derivatives, double step) {
  Spline2 spline;
  spline.degree = 3;
  const auto add = [&](const Vec2& p) { spline.poles.emplace_back(p.x(), p.y(), 1); };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) add(points[i] - step / 3 * derivatives[i]);
    add(points[i]);
    if (i + 1 < points.size()) add(points[i] + step / 3 * derivatives[i]);
    for (int k = 0; k < 3; ++k) spline.knots.push_back(static_cast<double>(i));
  }
  spline.knots.insert(spline.knots.begin(), spline.knots.front());
  spline.knots.push_back(spline.knots.back());
  return spline;
}

/// Along a wave; the walls are free-form curves, off the true ones by some 1e-8 of the width.
inline BentSlot splineSlot(std::mt19937_64& random, double width) {
  std::uniform_real_distribution<double> unit(0, 1);
  BentSlot slot;
  slot.width = width;
  const double half = width / 2, wide = width * (6 + 12 * unit(random));  // over which it waves
  const double high = 0.06 * wide * (0.3 + unit(random)), phase = fullTurn * unit(random), waves = 1 + unit(random);
  const double pace = waves * fullTurn / wide;
  // The wave bends by high pace^2 at most: less than half of what the width allows.
  const double height = std::min(high, 0.8 / (pace * pace * width));
  const auto headingAt = [&](double x) {
    return Heading{{x, height * std::sin(pace * x + phase)}, std::atan(height * pace * std::cos(pace * x + phase))};
  };
  const auto wallAt = [&](double side) {
    constexpr int pieces = 240;
    const double step = wide / pieces;
    std::vector<Vec2> points, derivatives;
    for (int i = 0; i <= pieces; ++i) {
      const double x = wide * i / pieces;
      const Heading heading = headingAt(x);
      const double slope = std::tan(heading.angle), bend = -height * pace * pace * std::sin(pace * x + phase);
      const double speed = std::hypot(1, slope), curvature = bend / (speed * speed * speed);
      points.push_back(heading.beside(side));
      derivatives.push_back(speed * (1 - side * curvature) * heading.along());
    }
    return Path{{hermiteSpline(points, derivatives, step)}, false, "", {}};
  };
  slot.right = wallAt(-half);
  slot.left = reversed(wallAt(half));
  slot.start = headingAt(0);
  slot.finish = headingAt(wide);
  constexpr int steps = 10000;
  for (int i = 0; i < steps; ++i) slot.length += wide / steps / std::cos(headingAt(wide * (i + 0.5) / steps).angle);
  slot.told = fmt::format("a wave {:.17g} wide, {:.4g} long", width, slot.length);
  closeEnds(slot);
  return slot;
}

/// Square rooms at both ends, three times as wide, behind straight necks; of slots that do not turn back to them.
inline BentSlot withRooms(BentSlot slot) {
  const double half = slot.width / 2, room = 1.5 * slot.width;
  Path loop;
  loop.closed = true;
  const auto line = [&](const Vec2& a, const Vec2& b) { loop.segments.emplace_back(Line2{a, b}); };
  const auto add = [&](const Heading& end) {
    const Heading heading{end.at + slot.width * end.along(), end.angle};
    line(end.beside(-half), heading.beside(-half));
    const Heading back{heading.at + 2 * room * heading.along(), heading.angle};
    line(heading.beside(-half), heading.beside(-room));
    line(heading.beside(-room), back.beside(-room));
    line(back.beside(-room), back.beside(room));
    line(back.beside(room), heading.beside(room));
    line(heading.beside(room), heading.beside(half));
    line(heading.beside(half), end.beside(half));
  };
  addWall(slot.right, loop);
  add(slot.finish);
  addWall(slot.left, loop);
  add({slot.start.at, slot.start.angle + fullTurn / 2});
  slot.part.loops = {loop};
  slot.told += ", with rooms";
  return slot;
}

}  // namespace blossom::test
