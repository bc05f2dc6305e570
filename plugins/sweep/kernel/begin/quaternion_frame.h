#pragma once
#include <Eigen/Geometry>
#include <cmath>

#include "core/vector.h"

/// Quaternions (w, x, y, z) of any length as rotations.
namespace blossom::sweep::quaternion {

/// Hamilton's product: first b, then a.
inline Vec4 times(const Vec4& a, const Vec4& b) {
  const Vec3 x = a.tail<3>(), y = b.tail<3>(), z = a[0] * y + b[0] * x + x.cross(y);
  return {a[0] * b[0] - x.dot(y), z.x(), z.y(), z.z()};
}

inline Vec4 conjugate(const Vec4& a) { return {a[0], -a[1], -a[2], -a[3]}; }

/// A turn about an axis of unit length.
inline Vec4 about(const Vec3& axis, double radians) {
  const Vec3 w = std::sin(radians / 2) * axis;
  return {std::cos(radians / 2), w.x(), w.y(), w.z()};
}

/// The rotation that takes the coordinate axes to three perpendicular unit vectors of positive orientation.
inline Vec4 ofAxes(const Vec3& x, const Vec3& y, const Vec3& z) {
  Eigen::Matrix3d columns;
  columns << x, y, z;
  const Eigen::Quaterniond q(columns);
  return {q.w(), q.x(), q.y(), q.z()};
}

inline Vec3 rotated(const Vec4& q, const Vec3& a) {
  const Vec3 axis = q.tail<3>();
  return ((q[0] * q[0] - axis.squaredNorm()) * a + 2 * axis.dot(a) * axis + 2 * q[0] * axis.cross(a)) / q.squaredNorm();
}

/// Angle in radians, 0 to pi, of the turn between two rotations.
inline double angleBetween(const Vec4& a, const Vec4& b) {
  const Vec4 turn = times(conjugate(a), b);
  return 2 * std::atan2(turn.tail<3>().norm(), std::abs(turn[0]));
}

}  // namespace blossom::sweep::quaternion
