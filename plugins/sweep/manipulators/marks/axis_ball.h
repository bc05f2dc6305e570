#pragma once
#include <optional>

#include "geometry/shape/motion.h"
#include "geometry/shape/motion_edit.h"
#include "scene/picking.h"

namespace blossom::sweep {

inline constexpr double axisPixels = 90;  ///< half the length of an axis on the screen

/// The end of the axis of a twist, by which it is turned about its centre on the trajectory.
struct AxisBall {
  Vec3 centre, axis;  ///< unit length
  double length = 0;  ///< mm, from the centre to the ball

  [[nodiscard]] Vec3 at() const { return centre + length * axis; }
};

/// Of a twist, at its first place; nothing of a pull. @param pixel mm
std::optional<AxisBall> axisBall(const Motion&, const MotionEdit&, double pixel);

/// The axis, of unit length, that takes the ball under a ray: on the side of the centre where it is, towards the viewer or
/// away from him, and at the rim of its sphere when the ray passes beside.
Vec3 axisUnder(const AxisBall&, const Ray&);

/// The nearest, either way round, of the axes of the document and of those that a twist at a place can have.
Vec3 nearestNamedAxis(const Vec3& axis, const Motion&, const MotionPlace&);

/// With three decimals, as the document is to have it: about half a tenth of a degree.
Vec3 readableAxis(const Vec3&);

}  // namespace blossom::sweep
