#pragma once
#include "geometry/planar/region.h"

/// Exact outlines of everyday shapes: straight sides are lines, round ones arcs, ellipses rational quadratic splines. Angles
/// are in radians, counter-clockwise from +x; every loop runs counter-clockwise.
namespace blossom::modeling {

/// A regular polygon with its corners on a circle; the first one lies at angle `rotation`.
/// @throws Error InvalidParameter for fewer than 3 sides or a radius that is not positive.
Region regularPolygon(int sides, double radius, const Vec2& center, double rotation);
/// The radius of the circle through the corners of a regular polygon whose sides touch a circle of radius `inner`.
double circumradius(int sides, double inner);

/// `points` corners at `outer` and as many at `inner` between them; the first outer one at angle `rotation`.
/// @throws Error InvalidParameter unless 0 < inner and 0 < outer and points >= 2.
Region star(int points, double outer, double inner, const Vec2& center, double rotation);

/// Half-axes a (at angle `rotation`) and b; a true circle, one arc, when they are equal.
/// @throws Error InvalidParameter unless both are positive.
Region ellipse(double a, double b, const Vec2& center, double rotation);
Region circle(double radius, const Vec2& center);

/// With corners rounded by arcs of radius `corner` (0: sharp); half of the shorter side gives round ends.
/// @throws Error InvalidParameter when the corners do not fit.
Region rectangle(double width, double height, double corner, const Vec2& center, double rotation);

/// Two half circles of diameter `width` joined by lines, `length` from end to end. @throws Error InvalidParameter when it is
/// wider than long.
Region slot(double length, double width, const Vec2& center, double rotation);

}  // namespace blossom::modeling
