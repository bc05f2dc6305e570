#pragma once
#include "geometry/shape/motion.h"
#include "kernel/grid/basis_table.h"

namespace blossom::sweep {

/// A point of the swept surface with its derivatives.
struct MotionPoint {
  Vec3 point, du, dv, duv;
  double weight = 0;  ///< W = tw |r|^2 sw, the denominator of the rational surface
};

/// x(u,v) = M(u,v) p computed from the factors, with the derivatives x_u, x_v and x_uv (Yoon & Lee 2009, section 3). At a
/// knot where the motion is not smooth, `sideU` and `sideV` choose the piece. O(degree^2).
MotionPoint evaluate(const Motion&, double u, double v, KnotSide sideU = KnotSide::Right, KnotSide sideV = KnotSide::Right);

}  // namespace blossom::sweep
