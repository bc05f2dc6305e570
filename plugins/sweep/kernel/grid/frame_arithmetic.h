#pragma once
#include "kernel/grid/vector_width.h"

namespace blossom::sweep {

/// Vectors and quaternions of plain doubles, which the compiler keeps apart in registers when a loop over them is
/// vectorised; Eigen's fixed sizes would bind them to the narrowest width.
struct Triple {
  double x, y, z;
};
struct Quaternion {
  double w, x, y, z;
};

BLOSSOM_INLINE Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
BLOSSOM_INLINE Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
BLOSSOM_INLINE Triple operator*(double k, const Triple& a) { return {k * a.x, k * a.y, k * a.z}; }
BLOSSOM_INLINE double dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
BLOSSOM_INLINE Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

BLOSSOM_INLINE double dot(const Quaternion& a, const Quaternion& b) { return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z; }
/// The vector part of conj(a) b.
BLOSSOM_INLINE Triple relative(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.x - a.x * b.w - a.y * b.z + a.z * b.y, a.w * b.y - a.y * b.w - a.z * b.x + a.x * b.z,
          a.w * b.z - a.z * b.w - a.x * b.y + a.y * b.x};
}
/// Q(q)^T a / |q|^2, given 2 / |q|^2: the vector turned back by a quaternion of any length.
BLOSSOM_INLINE Triple turnedBack(const Quaternion& q, double two, const Triple& a) {
  const Triple axis = {q.x, q.y, q.z}, across = cross(axis, a);
  return a + two * (cross(axis, across) - q.w * across);
}

}  // namespace blossom::sweep
