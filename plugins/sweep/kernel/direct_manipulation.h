#pragma once
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Minimum-norm direct manipulation: with the basis row N at (u, v) the poles move by N / sum(N^2) times the change wanted
/// there (Yoon & Lee 2009, section 4; Piegl & Tiller, The NURBS Book, section 11.2). The repeated rows of a closed motion
/// follow.

/// Pulls x(u,v) to `to` by the scaling alone: its components become s_w y_i / p_i with y = Q^T (to - t) / |r|^2.
/// @throws Error InvalidParameter when p has a zero component along which the point would have to move.
void dragScaling(Motion&, double u, double v, const Vec3& to);

/// Turns the moving frame at (u, v) by `degrees` about `axis` (in space), and its neighbourhood with it.
/// @throws Error InvalidParameter for an axis of no length.
void twistOrientation(Motion&, double u, double v, const Vec3& axis, double degrees);

}  // namespace blossom::sweep
