#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/planar/planar.h"
#include "support/random.h"
#include "support/regions.h"

/// Regions of arcs and splines.
namespace blossom::test {

/// A polygon with its corners rounded by arcs that touch the sides; convex ones and hollow ones.
inline Path roundedPath(const std::vector<Vec2>& corners, double radius) {
  const std::size_t n = corners.size();
  Path path;
  path.closed = true;
  std::vector<Arc2> arcs;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = corners[i] - corners[(i + n - 1) % n], out = corners[(i + 1) % n] - corners[i];
    const double turn = std::atan2(cross(in, out), in.dot(out));
    const double room = 0.45 * std::min(in.norm(), out.norm());
    const double r = std::min(radius, room / std::tan(std::abs(turn) / 2));
    const double setback = r * std::tan(std::abs(turn) / 2), side = turn > 0 ? 1 : -1;
    const Vec2 along = in.normalized(), left(-along.y(), along.x());
    const Vec2 start = corners[i] - setback * along, centre = start + side * r * left;
    arcs.push_back({centre, r, std::atan2(start.y() - centre.y(), start.x() - centre.x()), turn});
  }
  for (std::size_t i = 0; i < n; ++i) {
    path.segments.emplace_back(arcs[i]);
    path.segments.emplace_back(Line2{endPoint(Segment(arcs[i])), startPoint(Segment(arcs[(i + 1) % n]))});
  }
  return path;
}

/// A rounded spiky outline, sometimes with a round hole, with a rounded neighbour or as it was before rounding.
inline Region anyRounded(Random& random, double reach) {
  const auto spiky = [&](const Vec2& at) { return spikyPoints(random, at, reach, uniformInt(random, 3, 9)); };
  Region region{{roundedPath(spiky({0, 0}), reach * uniform(random, 0.02, 0.3))}};
  switch (uniformInt(random, 0, 3)) {
    case 0: {
      Path outer = polygonPath({{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}});
      Path hole = circleRegion(reach * uniform(random, 0.2, 0.9), {0, 0}).loops.front();
      region.loops = {outer, blossom::reversed(hole)};
      break;
    }
    case 1:
      region.loops.push_back(roundedPath(spiky({2.5 * reach, 0}), 0.1 * reach));
      break;
    case 2:
      region = circleRegion(reach * uniform(random, 0.1, 1));
      break;
    default:
      break;
  }
  return region;
}

/// A smooth closed cubic B-spline with hollows.
inline Region freeRegion(Random& random, double reach) {
  const int n = uniformInt(random, 5, 9);
  Spline2 spline{3, {}, {}};
  for (int i = 0; i < n + 3; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    if (i < n) {
      const double r = reach * uniform(random, 0.4, 1);
      spline.poles.push_back(Vec2(r * std::cos(angle), r * std::sin(angle)).homogeneous());
    } else {
      spline.poles.push_back(spline.poles[static_cast<std::size_t>(i - n)]);
    }
  }
  for (int i = 0; i < n + 7; ++i) spline.knots.push_back(i);
  Path path;
  path.closed = true;
  path.segments.emplace_back(spline);
  return {{path}};
}

}  // namespace blossom::test
