#pragma once
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Drags of one place in a motion of one's own, in place: the shortest way to `pull` and `twist`, which do the work.

/// Moves x(u,v) to `to` by the scaling alone: its components become s_w y_i / p_i with y = Q^T (to - t) / |r|^2.
/// @throws Error InvalidParameter when p is zero in a component in which the point would have to move, or the poles around
/// cannot reach the place.
void dragScaling(Motion&, double u, double v, const Vec3& to);

/// Rotates the moving frame at (u, v) by `degrees` about `axis` (in space); neighbouring frames follow.
/// @throws Error InvalidParameter for an axis of length zero.
void twistOrientation(Motion&, double u, double v, const Vec3& axis, double degrees);

}  // namespace blossom::sweep
