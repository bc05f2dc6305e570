#pragma once
#include <QPointF>
#include <optional>

#include "ui/plugin/tool.h"

namespace blossom::sweep {

/// How far the mouse takes a point in space: in the plane through it that faces the viewer, or along an axis. It begins at
/// zero exactly, wherever the point was taken hold of.
class PoleDrag {
 public:
  PoleDrag() = default;
  /// @param axis unit length; none: in the plane
  PoleDrag(const Vec3& start, std::optional<Vec3> axis, const Ray&);

  /// Where the mouse determines no place, the displacement before.
  void follow(const Ray&);
  [[nodiscard]] const Vec3& moved() const { return moved_; }
  [[nodiscard]] const std::optional<Vec3>& axis() const { return axis_; }

 private:
  [[nodiscard]] std::optional<Vec3> place(const Ray&) const;

  Vec3 start_ = Vec3::Zero(), moved_ = Vec3::Zero(), off_ = Vec3::Zero(), towards_ = Vec3::UnitY();
  std::optional<Vec3> axis_;
};

}  // namespace blossom::sweep
