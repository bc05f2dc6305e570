#pragma once
#include <cstddef>

#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Shapes that a motion can begin with.
enum class PrimitiveKind {
  Cylinder,  ///< radius, height; along z from the origin
  Cone,      ///< radius, topRadius, height; along z from the origin
  Sphere,    ///< radius; about the origin, from the south pole to the north pole
  Torus,     ///< radius of the ring, profile; about z
  Tube,      ///< a bent tube, part of a torus: radius of the bend, profile, angle
  Helicoid,  ///< radius, height, turns; about z from the origin; not closed
  Plane,     ///< width along x, height along y; its middle at the origin; not closed
  Sheet      ///< an arched sheet, part of a cylinder: radius, height, angle; not closed
};

struct PrimitiveOptions {
  PrimitiveKind kind = PrimitiveKind::Cylinder;
  double radius = 20;     ///< mm
  double profile = 6;     ///< mm, radius of the section of a torus or a tube, below `radius`
  double topRadius = 10;  ///< mm, of a cone; 0 makes a point
  double width = 60;      ///< mm, of a plane
  double height = 40;     ///< mm
  double angle = 120;     ///< degrees, of a tube or a sheet, above 0 and below 360
  double turns = 2;       ///< of a helicoid; below 0: clockwise
  /// Spans of the control nets in u and in v: more of them let pulls be more local. At least 4 around a full turn.
  std::size_t rows = 12, columns = 8;
};

struct PrimitiveResult {
  Motion motion;
  double deviation = 0;  ///< mm, measured distance from the true helicoid; 0 for the others, which are exact
};

/// A bicubic motion whose surface is the shape itself: with half-angle splines as quaternions every point is turned on an
/// exact circle, whatever the length of the quaternion (d = |r|^2 divides out; Yoon & Lee 2009, section 3), and the
/// trajectory of a torus keeps step with them as the rational curve c^2 / |c|^2 of degree 6. Only a helicoid is no rational
/// surface: its angle is not quite linear in v, by 5e-7 radians with the 16 spans for each turn that it has at least.
///
/// The swept point is (1, 1, 1), and factors of the scaling are 0 where the shape has no extent, so that a pull by
/// scaling alone can reach every place.
/// @throws Error InvalidParameter naming the size that cannot be. O(rows * columns).
PrimitiveResult primitiveMotion(const PrimitiveOptions&);

}  // namespace blossom::sweep
