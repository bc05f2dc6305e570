#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Knots to insert, in any order; a knot may stand several times.
struct MotionKnots {
  std::vector<double> u;                                       ///< into orientation and scaling
  std::vector<double> v;                                       ///< into all three factors
  bool trajectory = true, orientation = true, scaling = true;  ///< which of the factors get them
};

/// The same motion with more poles, so that a pull moves a smaller part of it. Around a motion closed in u, a knot has one
/// place, whatever the period; its end is its start. Every new pole is a convex combination of old ones (Oslo algorithm,
/// Cohen, Lyche & Riesenfeld 1980), so values change by rounding alone: 1e-15 of the poles. The knots become base knots:
/// edits of every level reach less far there. O(poles * knots).
/// @throws Error InvalidParameter for a knot outside the domain or one that would be more multiple than the degree, at which
/// the factor could tear.
Motion withKnots(const Motion&, const MotionKnots&);

}  // namespace blossom::sweep
