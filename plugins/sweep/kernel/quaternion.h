#pragma once
#include <Eigen/Geometry>
#include <cmath>

#include "core/vector.h"

/// Quaternions (w, x, y, z) of any length, as the orientation of a motion has them.
namespace blossom::sweep {

/// Hamilton's product: first b, then a.
inline Vec4 times(const Vec4& a, const Vec4& b) {
  const Vec3 x = a.tail<3>(), y = b.tail<3>(), z = a[0] * y + b[0] * x + x.cross(y);
  return {a[0] * b[0] - x.dot(y), z.x(), z.y(), z.z()};
}

inline Vec4 conjugate(const Vec4& q) { return {q[0], -q[1], -q[2], -q[3]}; }

/// The unit quaternion of a rotation about an axis of unit length.
inline Vec4 rotationAbout(const Vec3& axis, double radians) {
  const Vec3 w = std::sin(radians / 2) * axis;
  return {std::cos(radians / 2), w.x(), w.y(), w.z()};
}

/// The rotation that takes the coordinate axes to three perpendicular unit vectors of positive orientation.
inline Vec4 rotationOfAxes(const Vec3& x, const Vec3& y, const Vec3& z) {
  Eigen::Matrix3d columns;
  columns << x, y, z;
  const Eigen::Quaterniond q(columns);
  return {q.w(), q.x(), q.y(), q.z()};
}

/// The vector a turned by q: Q(q) a / |q|^2.
inline Vec3 turned(const Vec4& q, const Vec3& a) {
  const Vec3 axis = q.tail<3>();
  const Vec3 sum = (q[0] * q[0] - axis.squaredNorm()) * a + 2 * axis.dot(a) * axis + 2 * q[0] * axis.cross(a);
  return sum / q.squaredNorm();
}

/// The vector a turned back by q: Q(q)^T a / |q|^2.
inline Vec3 turnedBack(const Vec4& q, const Vec3& a) { return turned(conjugate(q), a); }

/// Angle of the turn between two rotations, radians, 0 to pi.
inline double angleBetween(const Vec4& a, const Vec4& b) {
  const Vec4 turn = times(conjugate(a), b);
  return 2 * std::atan2(turn.tail<3>().norm(), std::abs(turn[0]));
}

}  // namespace blossom::sweep
