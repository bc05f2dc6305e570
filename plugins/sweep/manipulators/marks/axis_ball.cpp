#include "manipulators/marks/axis_ball.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/bspline/bspline.h"
#include "manipulators/drag_target.h"

namespace blossom::sweep {

std::optional<AxisBall> axisBall(const Motion& motion, const MotionEdit& edit, double pixel) {
  const auto* twist = std::get_if<MotionTwist>(&edit);
  if (!twist || twist->at.empty() || !(twist->axis.norm() > 0)) return std::nullopt;
  return AxisBall{point(motion.trajectory, twist->at.front().v), twist->axis.normalized(), axisPixels * pixel};
}

Vec3 axisUnder(const AxisBall& ball, const Ray& ray) {
  const Vec3 foot = ray.origin + (ball.centre - ray.origin).dot(ray.direction) * ray.direction, off = foot - ball.centre;
  const double depth = ball.length * ball.length - off.squaredNorm();
  if (depth <= 0) return off.normalized();
  const double side = ball.axis.dot(ray.direction) > 0 ? 1 : -1;
  return (off + side * std::sqrt(depth) * ray.direction).normalized();
}

Vec3 nearestNamedAxis(const Vec3& axis, const Motion& motion, const MotionPlace& at) {
  std::vector<Vec3> named{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  for (const auto each : {PullMode::Axis::Tangent, PullMode::Axis::Arm, PullMode::Axis::Across})
    named.push_back(twistAxis(motion, at, each));
  const auto along = [&](const Vec3& each) { return std::abs(each.dot(axis)); };
  const Vec3 nearest =
      *std::max_element(named.begin(), named.end(), [&](const Vec3& a, const Vec3& b) { return along(a) < along(b); });
  return nearest.dot(axis) < 0 ? Vec3(-nearest) : nearest;
}

Vec3 readableAxis(const Vec3& axis) {
  constexpr double steps = 1000;
  return (steps * axis).array().round().matrix() / steps + Vec3::Zero();  // no zero has a sign
}

}  // namespace blossom::sweep
