#pragma once
#include "geometry/planar/region.h"

/// Exact outlines of everyday shapes: straight sides are lines, round ones arcs, ellipses rational quadratic splines. Angles
/// are in radians, counter-clockwise from +x; every loop runs counter-clockwise.
namespace blossom::modeling {

/// A regular polygon with corners on a circle, the first one at angle `rotation`.
/// @throws Error InvalidParameter for fewer than 3 sides or a radius that is not positive.
Region regularPolygon(int sides, double radius, const Vec2& center, double rotation);
/// The circumradius of a regular polygon with inradius `inner`.
double circumradius(int sides, double inner);

/// A star with `points` corners at radius `outer` and as many at `inner` between them, the first outer one at angle
/// `rotation`.
/// @throws Error InvalidParameter unless 0 < inner and 0 < outer and points >= 2.
Region star(int points, double outer, double inner, const Vec2& center, double rotation);

/// An ellipse with half-axes a (at angle `rotation`) and b; a circle, as one arc, when they are equal.
/// @throws Error InvalidParameter unless both are positive.
Region ellipse(double a, double b, const Vec2& center, double rotation);
Region circle(double radius, const Vec2& center);

/// A rectangle with corners rounded by arcs of radius `corner` (0: sharp); with half of the shorter side the ends are half
/// circles.
/// @throws Error InvalidParameter when the corners do not fit.
Region rectangle(double width, double height, double corner, const Vec2& center, double rotation);

/// Two half circles of diameter `width` joined by lines, `length` from end to end. @throws Error InvalidParameter when it is
/// wider than long.
Region slot(double length, double width, const Vec2& center, double rotation);

}  // namespace blossom::modeling
