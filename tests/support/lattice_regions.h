#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "geometry/planar/planar.h"
#include "support/random.h"
#include "support/regions.h"

/// Regions of lines and arcs on a lattice, so that walls, corners, circles and points where they touch fall together.
namespace blossom::test {

/// A rectangle with two half discs at its ends, whose lines and arcs touch.
inline Region slotRegion(const Vec2& from, double length, double radius) {
  using std::numbers::pi;
  const Vec2 to = from + Vec2(length, 0), up(0, radius);
  Path path;
  path.closed = true;
  path.segments = {Line2{from - up, to - up}, Arc2{to, radius, -pi / 2, pi}, Line2{to + up, from + up},
                   Arc2{from, radius, pi / 2, pi}};
  return {{path}};
}

inline Region ringRegion(const Vec2& center, double outer, double inner) {
  return {{circleRegion(outer, center).loops.front(), reversed(circleRegion(inner, center).loops.front())}};
}

inline Region latticeRegion(Random& random) {
  const auto at = [&] { return Vec2(uniformInt(random, 0, 6), uniformInt(random, 0, 6)); };
  const Vec2 low = at();
  switch (uniformInt(random, 0, 4)) {
    case 0:
      return rectangleRegion(low, low + Vec2(uniformInt(random, 1, 5), uniformInt(random, 1, 5)));
    case 1:
      return circleRegion(uniformInt(random, 1, 3), low);
    case 2:
      return slotRegion(low, uniformInt(random, 1, 5), uniformInt(random, 1, 2));
    case 3:
      return ringRegion(low, uniformInt(random, 2, 4), 1);
    default:
      return polygonRegion({low, low + Vec2(uniformInt(random, 1, 4), 0), low + Vec2(0, uniformInt(random, 1, 4))});
  }
}

inline Region moved(const Region& region, double scale, double angle, const Vec2& by) {
  Eigen::Matrix<double, 2, 3> map;
  map << scale * std::cos(angle), -scale * std::sin(angle), by.x(), scale * std::sin(angle), scale * std::cos(angle), by.y();
  Region result;
  for (const Path& loop : region.loops) result.loops.push_back(transformed(loop, map));
  return result;
}

}  // namespace blossom::test
