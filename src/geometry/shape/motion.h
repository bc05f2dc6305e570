#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/vector.h"
#include "geometry/bspline/spline_space.h"
#include "geometry/shape/motion_edit.h"

namespace blossom {

/// Closure of the orientation in u. A full turn maps a quaternion q to -q, hence "anti-periodic".
enum class ClosedU { No, Periodic, AntiPeriodic };

/// The knots strictly inside the domain between which edits of level 0 reach. A motion that was refined for edits of finer
/// levels keeps those it had before, so that a level means the same wherever it has been refined.
struct BaseKnots {
  std::vector<double> trajectory;
  std::array<std::vector<double>, 2> orientation, scaling;  ///< in u, in v
  friend bool operator==(const BaseKnots&, const BaseKnots&) = default;
};

/// A motion in two parameters, x(u,v) = T(v) R(u,v) S(u,v) p (Yoon & Lee 2009, section 3). All factors have the same domain.
/// When closed in u, the surfaces store the *unwrapped* poles: the first degreeU rows are repeated at the end (negated in
/// the orientation if anti-periodic) under an unclamped knot vector.
struct Motion {
  Curve trajectory;     ///< t(v), homogeneous (w x, w y, w z, w)
  Surface orientation;  ///< r(u,v), quaternions (w, x, y, z), not normalised
  Surface scaling;      ///< s(u,v) = (sx, sy, sz, sw)
  ClosedU closedU = ClosedU::No;
  Vec3 point{0, 0, 1};  ///< p, in the moving frame
  /// Changes that are not yet in the factors, in order. What sweeps or edits the motion applies them first, so that a motion
  /// that is only read and written keeps them.
  std::vector<MotionEdit> edits = {};
  std::optional<BaseKnots> base = {};  ///< each a part of the factor's knots; none: these are the base

  [[nodiscard]] std::pair<double, double> domainU() const { return orientation.domainU(); }
  [[nodiscard]] std::pair<double, double> domainV() const { return orientation.domainV(); }
  friend bool operator==(const Motion&, const Motion&) = default;
};

/// How often the knot at the seam stands in one period u0..un of a closed factor: u0 and un are the same one.
int seamMultiplicity(const std::vector<double>& periodU);

/// Unwrapped surface from the n = periodU.size() - 1 rows of a periodic one over the knots u0..un: the first degreeU rows
/// are repeated at the end, times `sign` for each period passed (-1 for anti-periodic quaternions).
Surface unwrapped(int degreeU, int degreeV, const std::vector<double>& periodU, std::vector<double> knotsV,
                  std::vector<Vec4> poles, double sign);

/// @throws Error InvalidInput naming the factor and the mistake: sizes, knots, domains that differ, values that are not
/// finite, weights that are not positive, a factor that a knot tears apart, at the seam, too, a closed
/// one whose last rows do not repeat its first ones, base knots that the
/// factor does not have.
void validate(const Motion&);

/// Result of alignQuaternions.
struct QuaternionAlignment {
  std::size_t flipped = 0;  ///< poles whose sign was changed
  std::size_t opposed = 0;  ///< neighbouring poles that still point away from each other (more than half a turn apart)
  std::size_t row = 0, column = 0;  ///< of the first opposed pair
};

/// Chooses the signs of the orientation's poles so that neighbours point the same way, in u and v and across the seam of a
/// closed motion, because q and -q are the same rotation but a spline between them passes near zero. Leaves all signs
/// unchanged when no choice is better. A guess, for quaternions whose signs carry no meaning: of a motion that was edited,
/// it can make another one, as a twist of one place beyond half a turn leaves neighbours that point away from each other.
/// O(poles).
QuaternionAlignment alignQuaternions(Motion&);

}  // namespace blossom
