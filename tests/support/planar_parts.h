#pragma once
#include <cmath>
#include <vector>

#include "core/angle.h"
#include "geometry/planar/region.h"

/// Parts with closed forms, and free-form ones, for pockets.
namespace blossom::test {

inline Path polygonPath(const std::vector<Vec2>& corners, bool hole = false) {
  std::vector<Vec2> all = corners;
  if (hole) all.assign(corners.rbegin(), corners.rend());
  Path path;
  path.closed = true;
  for (std::size_t i = 0; i < all.size(); ++i) path.segments.emplace_back(Line2{all[i], all[(i + 1) % all.size()]});
  return path;
}

inline Path boxPath(double x0, double y0, double x1, double y1, bool hole = false) {
  return polygonPath({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, hole);
}

inline Path circlePath(const Vec2& center, double radius, bool hole = false) {
  Path path;
  path.closed = true;
  path.segments.emplace_back(Arc2{center, radius, 0, hole ? -fullTurn : fullTurn});
  return path;
}

/// A closed cubic spline with poles on a circle whose radius waves.
inline Path wavyPath(const Vec2& center, double radius, double wave, int waves, bool hole = false) {
  Spline2 spline;
  spline.degree = 3;
  const int count = 8 * waves;
  for (int i = 0; i < count + 3; ++i) {
    const double turn = fullTurn * (hole ? -i : i) / count;
    const double r = radius + wave * std::cos(waves * turn);
    spline.poles.emplace_back(center.x() + r * std::cos(turn), center.y() + r * std::sin(turn), 1);
  }
  for (int i = 0; i < count + 7; ++i) spline.knots.push_back(i);
  Path path;
  path.closed = true;
  path.segments.emplace_back(spline);
  return path;
}

}  // namespace blossom::test
