#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "core/vector.h"
#include "scene/picking.h"
#include "ui/plugin/tool.h"

/// What handles do that are dragged along a line.
namespace blossom::ui {

/// The place on a line nearest to a line of sight; nothing where it is seen from its end. @param axis unit vector
inline std::optional<Vec3> nearestOnLine(const Ray& sight, const Vec3& through, const Vec3& axis) {
  constexpr double grazing = 0.02;  // sine of the angle between both
  const Vec3 along = sight.direction.normalized(), across = along.cross(axis);
  if (across.norm() < grazing) return std::nullopt;
  const Vec3 normal = along.cross(across);  // of the plane through the line of sight and the common normal of both
  return Vec3(through + (sight.origin - through).dot(normal) / axis.dot(normal) * axis);
}

inline double distanceOf(const Ray& sight, const Vec3& p) {
  return (p - sight.origin).cross(sight.direction.normalized()).norm();
}

/// The step in which a length is dragged, mm.
inline double dragStep(const ToolHost& host) {
  constexpr double stepsPerGridSpacing = 20;
  return host.gridSpacing() / stepsPerGridSpacing;
}

/// The multiple of a step nearest to a value, in digits as short as those of the step: 0.3, not 3 * 0.1.
inline double nearestStep(double value, double step) {
  const double perMillimetre = 1 / step, whole = std::round(perMillimetre), steps = std::round(value / step);
  return std::abs(perMillimetre - whole) < 1e-9 * whole ? steps / whole : steps * step;
}

}  // namespace blossom::ui
