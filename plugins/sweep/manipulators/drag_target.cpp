#include "manipulators/drag_target.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/bspline/bspline.h"
#include "kernel/grid/motion_point.h"
#include "manipulators/marks/pull_ring.h"

namespace blossom::sweep {

namespace {

constexpr double degreesPerRadian = 180 / std::numbers::pi;

/// The side of a normal that faces the viewer, who looks nearly along it: a point of it would run away from the mouse.
std::optional<Vec3> normalSeenEndOn(const Vec3& normal, const Vec3& towards) {
  constexpr double nearly = 0.966;  // within 15 degrees, where a point would go four times as far as the mouse
  const double along = normal.dot(towards);
  if (std::abs(along) < nearly) return std::nullopt;
  return along > 0 ? Vec3(-normal) : normal;
}

}  // namespace

DragTarget::DragTarget(const PlaceHit& start, const Vec3& towards)
    : start_(start.point), now_(start.point), towards_(towards) {
  if (start.normal.squaredNorm() > 0) normal_ = start.normal;
}

DragTarget::DragTarget(const PlaceHit& start, const ui::ToolEvent& event) : DragTarget(start, event.ray.direction) {
  if (const auto held = inPlane(event.ray)) off_ = *held - start_;
}

std::optional<Vec3> DragTarget::inPlane(const Ray& ray) const {
  const double slope = towards_.dot(ray.direction);
  constexpr double grazing = 1e-6;
  if (slope <= grazing) return std::nullopt;
  return Vec3(ray.origin + towards_.dot(start_ - ray.origin) / slope * ray.direction);
}

const Vec3& DragTarget::follow(const ui::ToolEvent& event) {
  const auto held = inPlane(event.ray);
  if (event.modifiers.testFlag(Qt::ShiftModifier)) {
    followNormal(event.ray, held);
  } else if (held) {
    now_ = *held - off_;
  }
  return now_;
}

/// To the point of the normal that comes nearest to the line of sight; where it is seen end on, by the way of the mouse up.
void DragTarget::followNormal(const Ray& ray, const std::optional<Vec3>& held) {
  if (const auto outwards = normalSeenEndOn(normal_, towards_)) {
    if (held) now_ = start_ + (*held - off_ - start_).dot(facing(towards_, 1).up) * *outwards;
    return;
  }
  const double slant = normal_.dot(ray.direction), across = 1 - slant * slant;
  const Vec3 from = start_ + off_ - ray.origin;
  constexpr double endOn = 1e-6;
  if (across > endOn) now_ = start_ + (slant * from.dot(ray.direction) - from.dot(normal_)) / across * normal_;
}

Vec3 twistAxis(const Motion& motion, const MotionPlace& at, PullMode::Axis chosen) {
  const std::vector<Vec4> d = derivatives(motion.trajectory, at.v, 1);
  const Vec3 centre = d[0].head<3>() / d[0][3];
  const Vec3 tangent = d[1].head<3>() - d[1][3] * centre;
  const Vec3 arm = evaluate(motion, at.u, at.v).point - centre;
  const Vec3 axis = chosen == PullMode::Axis::Tangent ? tangent : chosen == PullMode::Axis::Arm ? arm : tangent.cross(arm);
  return axis.norm() > 0 ? Vec3(axis.normalized()) : Vec3::UnitZ();
}

double draggedAngle(const Vec3& axis, const Vec3& arm, const Vec3& moved, const Vec3& towards, double shortest) {
  const Vec3 radial = arm - arm.dot(axis) * axis;
  constexpr double faces = 0.5;
  if (std::abs(axis.dot(towards)) > faces && radial.norm() > shortest) {
    // Along the line of sight into the plane of the circle.
    const Vec3 end = radial + moved - axis.dot(moved) / axis.dot(towards) * towards;
    return degreesPerRadian * std::atan2(axis.dot(radial.cross(end)), radial.dot(end));
  }
  const Vec3 across = axis.cross(-towards);
  if (!(across.norm() > 0)) return 0;
  return degreesPerRadian * moved.dot(across.normalized()) / std::max(radial.norm(), shortest);
}

}  // namespace blossom::sweep
