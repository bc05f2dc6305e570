#pragma once
#include "core/vector.h"
#include "geometry/curve.h"
#include "geometry/surface.h"

namespace blossom {

/// How the orientation closes in u. One full turn takes a quaternion q to -q, hence "anti-periodic".
enum class ClosedU { No, Periodic, AntiPeriodic };

/// A motion in two parameters, x(u,v) = T(v) R(u,v) S(u,v) p (Yoon & Lee 2009, section 3). All factors share one domain.
/// When closed in u, the surfaces hold the *unwrapped* poles: the first degreeU rows again at the end (negated in the
/// orientation if anti-periodic) under an unclamped knot vector.
struct Motion {
  Curve trajectory;     ///< t(v), homogeneous (w x, w y, w z, w)
  Surface orientation;  ///< r(u,v), quaternions (w, x, y, z), not normalised
  Surface scaling;      ///< s(u,v) = (sx, sy, sz, sw)
  ClosedU closedU = ClosedU::No;
  Vec3 point{0, 0, 1};  ///< p, in the moving frame
  friend bool operator==(const Motion&, const Motion&) = default;
};

}  // namespace blossom
