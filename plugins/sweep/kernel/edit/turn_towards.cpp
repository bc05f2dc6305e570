#include "kernel/edit/turn_towards.h"

#include <Eigen/Geometry>
#include <cmath>

#include "kernel/quaternion.h"

namespace blossom::sweep {

namespace {

/// Sine of the angle from which two vectors determine an axis; below it, rounding would choose one.
constexpr double noAxis = 1e-12;

Vec3 normalPart(const Vec3& axis, const Vec3& unit) {
  const Vec3 once = axis - axis.dot(unit) * unit;
  return once - once.dot(unit) * unit;
}

}  // namespace

TurnTowards turnTowards(const Vec3& a, const Vec3& b, double share, const Vec3& axis, double smallest) {
  if (!(a.norm() > smallest)) return {std::nullopt, Unreached::OnTrajectory};
  if (!(b.norm() > smallest)) return {std::nullopt, Unreached::TargetOnTrajectory};
  const Vec3 from = a.normalized(), to = b.normalized();
  const Vec3 normal = from.cross(to);
  const double sine = normal.norm(), cosine = from.dot(to), angle = share * std::atan2(sine, cosine);
  if (sine == 0 && cosine > 0) return {Vec4(1, 0, 0, 0)};
  if (sine > noAxis || cosine > 0) return {rotationAbout(normalPart(normal / sine, from).normalized(), angle)};
  const Vec3 chosen = normalPart(axis, from);
  if (axis.isZero(0)) return {std::nullopt, Unreached::Opposite};
  if (!(chosen.norm() > noAxis * axis.norm())) return {std::nullopt, Unreached::AxisAlongArm};
  return {rotationAbout(chosen.normalized(), angle)};
}

}  // namespace blossom::sweep
