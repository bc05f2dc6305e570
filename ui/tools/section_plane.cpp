#include "ui/tools/section_plane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace blossom::ui {

SectionPlane SectionPlane::through(const Bounds& box) {
  SectionPlane plane;
  plane.setAxis(SectionAxis::Y, box);
  return plane;
}

SectionPlane SectionPlane::of(const CutPlane& cut) {
  SectionPlane plane;
  Eigen::Index along = 0;
  const bool straight = cut.normal.cwiseAbs().maxCoeff(&along) > 1 - 1e-12;
  plane.axis_ = straight ? static_cast<SectionAxis>(along) : SectionAxis::Face;
  plane.flipped_ = straight && cut.normal[along] < 0;
  plane.direction_ = straight ? Vec3(Vec3::Unit(along)) : cut.normal;
  plane.offset_ = plane.flipped_ ? -cut.offset : cut.offset;
  return plane;
}

void SectionPlane::setAxis(SectionAxis axis, const Bounds& box) {
  if (axis == SectionAxis::Face) return;
  axis_ = axis;
  direction_ = Vec3::Unit(static_cast<Eigen::Index>(axis));
  flipped_ = axis == SectionAxis::Y;
  base_ = 0;
  offset_ = box.empty ? 0 : box.center().dot(direction_);
}

void SectionPlane::setFace(const Vec3& point, const Vec3& normal) {
  axis_ = SectionAxis::Face;
  direction_ = normal.normalized();
  base_ = point.dot(direction_);
  offset_ = 0;
  flipped_ = false;
}

CutPlane SectionPlane::plane() const {
  const double place = base_ + offset_;
  return flipped_ ? CutPlane{-direction_, -place} : CutPlane{direction_, place};
}

std::pair<double, double> SectionPlane::range(const Bounds& box) const {
  if (box.empty) return {-100, 100};
  const double middle = box.center().dot(direction_) - base_;
  const double half = ((box.high - box.low) / 2).dot(direction_.cwiseAbs());
  return {middle - half, middle + half};
}

Vec3 SectionPlane::onPlane(const Vec3& p) const { return p + (base_ + offset_ - p.dot(direction_)) * direction_; }

std::optional<double> SectionPlane::offsetAlong(const Ray& ray, const Vec3& anchor) const {
  const double slant = ray.direction.dot(direction_);
  const double across = 1 - slant * slant;
  if (across < 0.02) return std::nullopt;
  const Vec3 between = ray.origin - anchor;
  const double along = (between.dot(direction_) - slant * between.dot(ray.direction)) / across;
  return anchor.dot(direction_) + along - base_;
}

}  // namespace blossom::ui
