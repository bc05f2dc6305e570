#pragma once
#include <cstdint>
#include <vector>

#include "kernel/polygons.h"

namespace blossom::minkowski {

/// A point of an integer grid, |x| and |y| <= 2^47, so that sums of points are exact and turns fit 128 bits.
struct GridPoint {
  std::int64_t x = 0, y = 0;
  friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
  friend GridPoint operator+(const GridPoint& a, const GridPoint& b) { return {a.x + b.x, a.y + b.y}; }
  friend GridPoint operator-(const GridPoint& a, const GridPoint& b) { return {a.x - b.x, a.y - b.y}; }
};

// ISO C++ has no name for it; the compilers we build with all have the type.
__extension__ using Wide = __int128;

using blossom::cross;  // of vectors, beside those of grid points
inline Wide cross(const GridPoint& a, const GridPoint& b) { return Wide(a.x) * b.y - Wide(a.y) * b.x; }
inline Wide dot(const GridPoint& a, const GridPoint& b) { return Wide(a.x) * b.x + Wide(a.y) * b.y; }

using GridLoop = std::vector<GridPoint>;

/// As Polygon, with every corner a proper turn: neither straight on nor back.
struct GridPolygon {
  GridLoop outer;
  std::vector<GridLoop> holes;
  friend bool operator==(const GridPolygon&, const GridPolygon&) = default;
};

/// A grid point p stands for origin + unit p.
struct Grid {
  Vec2 origin = Vec2::Zero();
  double unit = 1;  ///< a power of two
  [[nodiscard]] Vec2 point(const Vec2& p) const { return origin + unit * p; }
};

/// The finest unit in which boxes of this size fit, seen from their middles.
double gridUnit(const Vec2& largestSize);
/// Without equal neighbours, straight corners and antennas; empty when nothing else is left.
GridLoop cleaned(const GridLoop&);
/// Snaps to the nearest grid points. Specks become boxes; slivers and holes that collapse vanish.
std::vector<GridPolygon> snapped(const Polygons&, const Grid&);
/// From grid coordinates to where they stand, without collinear points and without crumbs of the grid's size, or of two
/// units in the last place of the coordinates where these are larger.
Polygons onPlane(const Polygons& inGridUnits, const Grid&);

}  // namespace blossom::minkowski
