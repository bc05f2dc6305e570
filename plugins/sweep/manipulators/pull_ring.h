#pragma once
#include <vector>

#include "manipulators/pull_mode.h"
#include "ui/tools/view_props.h"

namespace blossom::sweep {

/// A plane that faces the viewer, and its scale.
struct Facing {
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitZ();
  double pixel = 1;  ///< mm in a logical pixel
};
/// @param towards the line of sight, unit length
Facing facing(const Vec3& towards, double millimetresPerPixel);

/// Lines of the ring around a point: an arc with its letter for each of the shares T, R, S of a pull.
struct RingLines {
  std::vector<std::vector<Vec3>> active, idle;
  std::vector<std::vector<Vec3>> border;  ///< beside the arcs, so that they are seen on a surface of their own colour
};
RingLines ringLines(const Vec3& centre, const Facing&, const PullWeights&);

/// The axis of a twist through a point of the trajectory, and the arc from an arm by an angle. Where the arm has no length,
/// the arc has `radius`.
std::vector<std::vector<Vec3>> twistLines(const Vec3& centre, const Vec3& axis, const Vec3& arm, double degrees,
                                          double halfLength, double radius);

}  // namespace blossom::sweep
