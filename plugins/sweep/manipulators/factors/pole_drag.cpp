#include "manipulators/factors/pole_drag.h"

namespace blossom::sweep {

PoleDrag::PoleDrag(const Vec3& start, std::optional<Vec3> axis, const Ray& ray)
    : start_(start), towards_(ray.direction), axis_(std::move(axis)) {
  if (const auto held = place(ray)) off_ = *held;
}

/// From the start.
std::optional<Vec3> PoleDrag::place(const Ray& ray) const {
  const Vec3 from = start_ - ray.origin;
  if (!axis_) {
    const double slope = towards_.dot(ray.direction);
    constexpr double grazing = 1e-6;
    if (slope <= grazing) return std::nullopt;
    return Vec3(towards_.dot(from) / slope * ray.direction - from);
  }
  // The point of the axis nearest to the line of sight.
  const double slant = axis_->dot(ray.direction), across = 1 - slant * slant;
  constexpr double along = 1e-4;
  if (across < along) return std::nullopt;
  return Vec3((slant * ray.direction.dot(from) - axis_->dot(from)) / across * *axis_);
}

void PoleDrag::follow(const Ray& ray) {
  if (const auto held = place(ray)) moved_ = *held - off_;
}

}  // namespace blossom::sweep
