#pragma once
#include <algorithm>
#include <cstring>

#include "geometry/bspline/bspline.h"
#include "geometry/shape/motion.h"

/// What rounding errors of a motion are measured by, and its poles bit for bit.
namespace blossom::test {

/// The largest length that the poles of a motion stand for around (u, v): where basis functions nearly cancel each other,
/// poles are larger than what they add up to, and rounding with them.
inline double sizeOfPoles(const Motion& motion, double u, double v) {
  double trajectory = 0, reach = 0, frame = 0;
  for (const Vec4& pole : motion.trajectory.poles) trajectory = std::max(trajectory, pole.head<3>().norm() / pole[3]);
  const double weight = evaluate(motion.scaling, u, v)[3];
  for (const Vec4& pole : motion.scaling.poles)
    reach = std::max(reach, pole.head<3>().cwiseProduct(motion.point).norm() / weight);
  for (const Vec4& pole : motion.orientation.poles) frame = std::max(frame, pole.norm());
  const double turned = frame / evaluate(motion.orientation, u, v).norm();
  return trajectory + reach * std::max(1.0, turned);
}

inline bool sameBits(const std::vector<Vec4>& a, const std::vector<Vec4>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec4)) == 0;
}
inline bool sameBits(const Vec4& a, const Vec4& b) { return std::memcmp(a.data(), b.data(), sizeof(Vec4)) == 0; }

/// The rows that repeat the first ones do so bit for bit.
inline bool repeatsItsRows(const Surface& surface, ClosedU closed, double sign) {
  if (closed == ClosedU::No) return true;
  const std::size_t free = surface.countU() - static_cast<std::size_t>(surface.degreeU);
  for (std::size_t i = free; i < surface.countU(); ++i)
    for (std::size_t j = 0; j < surface.countV(); ++j) {
      const Vec4 wanted = sign * surface.pole(i - free, j);
      if (!sameBits(surface.pole(i, j), wanted)) return false;
    }
  return true;
}
inline bool repeatsItsRows(const Motion& motion) {
  return repeatsItsRows(motion.orientation, motion.closedU, motion.closedU == ClosedU::AntiPeriodic ? -1 : 1) &&
         repeatsItsRows(motion.scaling, motion.closedU, 1);
}

}  // namespace blossom::test
