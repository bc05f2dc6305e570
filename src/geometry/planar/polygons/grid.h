#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/planar/polygons/polygons.h"

namespace blossom::planar {

/// A point of an integer grid, |x| and |y| <= 2^47, so that sums of points are exact and turns fit 128 bits.
struct GridPoint {
  std::int64_t x = 0, y = 0;
  friend auto operator<=>(const GridPoint&, const GridPoint&) = default;  // NOLINT(modernize-use-nullptr)
  friend GridPoint operator+(const GridPoint& a, const GridPoint& b) { return {a.x + b.x, a.y + b.y}; }
  friend GridPoint operator-(const GridPoint& a, const GridPoint& b) { return {a.x - b.x, a.y - b.y}; }
};

// ISO C++ has no name for it; the compilers we build with all have the type.
__extension__ using Wide = __int128;

using blossom::cross;  // of vectors, beside those of grid points
inline Wide cross(const GridPoint& a, const GridPoint& b) { return Wide(a.x) * b.y - Wide(a.y) * b.x; }
inline Wide dot(const GridPoint& a, const GridPoint& b) { return Wide(a.x) * b.x + Wide(a.y) * b.y; }

using GridLoop = std::vector<GridPoint>;

/// As Polygon, but consecutive edges are never collinear. A curve without area is an outer loop there and back, whose
/// points but the ends come twice, and so carry their numbers; a point is one of one corner.
struct GridPolygon {
  GridLoop outer;
  std::vector<GridLoop> holes;
  std::vector<std::uint32_t> cornerNumbers{}, sideNumbers{};  ///< of the outer loop; empty: to be found by place
  friend bool operator==(const GridPolygon&, const GridPolygon&) = default;
};

/// Grid whose point p has the position origin + unit p.
struct Grid {
  Vec2 origin = Vec2::Zero();
  double unit = 1;  ///< a power of two
  [[nodiscard]] Vec2 point(const Vec2& p) const { return origin + unit * p; }
  /// The grid point nearest to a position.
  [[nodiscard]] GridPoint nearest(const Vec2& position) const {
    const Vec2 q = (position - origin) / unit;
    return {std::llround(q.x()), std::llround(q.y())};
  }
};

/// The smallest unit for which boxes of this size, centred at the origin of the grid, are representable.
double gridUnit(const Vec2& largestSize);
/// The loop without repeated points, collinear corners and antennas; empty when nothing is left.
GridLoop cleaned(const GridLoop&);
/// Rounds to the nearest grid points. Parts smaller than the grid become boxes or strips
/// of two units, which may overlap; slivers and holes that collapse are removed.
std::vector<GridPolygon> snapped(const Polygons&, const Grid&);
/// Converts grid coordinates to the plane, without collinear points and without parts smaller than the grid's unit or two
/// units in the last place of the coordinates, whichever is larger.
Polygons onPlane(const Polygons& inGridUnits, const Grid&);

}  // namespace blossom::planar
