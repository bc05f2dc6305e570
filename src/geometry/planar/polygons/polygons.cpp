#include "geometry/planar/polygons/polygons.h"

namespace blossom::planar {
namespace {

template <class F>
Polygons mapped(const Polygons& polygons, F f) {
  Polygons result = polygons;
  for (Polygon& polygon : result) {
    for (Vec2& p : polygon.outer) p = f(p);
    for (Loop& hole : polygon.holes)
      for (Vec2& p : hole) p = f(p);
  }
  return result;
}

}  // namespace

double signedArea(const Loop& loop) {
  if (loop.empty()) return 0;
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    twice += cross(loop[i] - loop.front(), loop[(i + 1) % loop.size()] - loop.front());
  return twice / 2;
}

double perimeter(const Loop& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  return sum;
}

double area(const Polygons& polygons) {
  double sum = 0;
  for (const Polygon& polygon : polygons) {
    sum += signedArea(polygon.outer);
    for (const Loop& hole : polygon.holes) sum += signedArea(hole);
  }
  return sum;
}

std::size_t edgeCount(const Polygons& polygons) {
  std::size_t count = 0;
  for (const Polygon& polygon : polygons) {
    count += polygon.outer.size();
    for (const Loop& hole : polygon.holes) count += hole.size();
  }
  return count;
}

Polygons scaled(const Polygons& polygons, double s) {
  return mapped(polygons, [s](const Vec2& p) { return Vec2(s * p); });
}

Polygons translated(const Polygons& polygons, const Vec2& by) {
  return mapped(polygons, [&by](const Vec2& p) { return Vec2(p + by); });
}

bool isConvex(const Polygons& polygons) {
  if (polygons.size() != 1 || !polygons.front().holes.empty()) return false;
  const Loop& loop = polygons.front().outer;
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 in = loop[(i + 1) % loop.size()] - loop[i];
    const Vec2 out = loop[(i + 2) % loop.size()] - loop[(i + 1) % loop.size()];
    if (cross(in, out) < -rounding * in.norm() * out.norm()) return false;
  }
  return true;
}

Box2 boxOf(const Polygons& polygons) {
  Box2 box;
  for (const Polygon& polygon : polygons)
    for (const Vec2& p : polygon.outer) box.extend(p);
  return box;
}

}  // namespace blossom::planar
