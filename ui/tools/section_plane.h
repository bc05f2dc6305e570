#pragma once
#include <optional>

#include "geometry/shape/bounds.h"
#include "scene/picking.h"

namespace blossom::ui {

enum class SectionAxis { X, Y, Z, Face };

/// The state of a section as its panel and handle show it: a direction, an offset along it and the side cut away.
class SectionPlane {
 public:
  /// Perpendicular to y through the middle.
  static SectionPlane through(const Bounds&);
  static SectionPlane of(const CutPlane&);

  /// X, Y or Z, through the middle, with the half cut away that is nearer in the home view.
  void setAxis(SectionAxis, const Bounds&);
  /// Parallel to a face; offsets are measured from it, outwards.
  void setFace(const Vec3& point, const Vec3& normal);
  void flip() { flipped_ = !flipped_; }
  void setOffset(double offset) { offset_ = offset; }

  [[nodiscard]] SectionAxis axis() const { return axis_; }
  [[nodiscard]] const Vec3& direction() const { return direction_; }
  [[nodiscard]] bool flipped() const { return flipped_; }
  [[nodiscard]] double offset() const { return offset_; }  ///< mm along the direction, from the origin or the face
  [[nodiscard]] CutPlane plane() const;
  /// Minimum and maximum offset at which the plane meets a box.
  [[nodiscard]] std::pair<double, double> range(const Bounds&) const;
  /// The point of the plane nearest to another.
  [[nodiscard]] Vec3 onPlane(const Vec3& p) const;
  /// Offset at which the line along the direction through `anchor` is nearest to a ray; empty when they are parallel.
  [[nodiscard]] std::optional<double> offsetAlong(const Ray&, const Vec3& anchor) const;

 private:
  SectionAxis axis_ = SectionAxis::Y;
  Vec3 direction_ = Vec3::UnitY();
  double base_ = 0;  // of offset 0, along the direction
  double offset_ = 0;
  bool flipped_ = false;
};

}  // namespace blossom::ui
