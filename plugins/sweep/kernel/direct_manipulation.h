#pragma once
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Minimum-norm direct manipulation: with the basis row N at (u, v) the poles move by N / sum(N^2) times the change wanted
/// there (Yoon & Lee 2009, section 4; Piegl & Tiller, The NURBS Book, section 11.2). The repeated rows of a closed motion
/// follow.

/// Minimum-norm direct manipulation: with the basis row N at (u, v) the poles move by N / sum(N^2) times the change wanted
/// there (Yoon & Lee 2009, section 4; Piegl & Tiller, The NURBS Book, section 11.2). The repeated rows of a closed motion
/// are updated as well.
///
/// Moves x(u,v) to `to` by the scaling alone: its components become s_w y_i / p_i with y = Q^T (to - t) / |r|^2.
/// @throws Error InvalidParameter when p is zero in a component in which the point would have to move.
void dragScaling(Motion&, double u, double v, const Vec3& to);

/// Rotates the moving frame at (u, v) by `degrees` about `axis` (in space); neighbouring frames follow.
/// @throws Error InvalidParameter for an axis of length zero.
void twistOrientation(Motion&, double u, double v, const Vec3& axis, double degrees);

}  // namespace blossom::sweep
