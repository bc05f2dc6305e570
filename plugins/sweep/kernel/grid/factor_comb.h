#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// How the factors of a motion bend along one line of parameters: what curvature combs show. Derivatives are exact; at a
/// knot the piece to the right counts, so that a jump is seen as one. Each O(samples * degree^2).

/// The parameter that runs along a comb; the other one is held at a value in the domain.
enum class CombAlong { U, V };

struct TrajectoryComb {
  std::vector<double> at;       ///< v
  std::vector<Vec3> point;      ///< t(v), mm
  std::vector<Vec3> curvature;  ///< the curvature times the unit vector to the centre, 1/mm; zero where t' vanishes
};

struct ScalingComb {
  std::vector<double> at;
  std::vector<Vec3> factors;  ///< f = (sx, sy, sz) / sw
  /// f'' / (1 + f'^2)^(3/2) of each factor, as a graph over the parameter counted from 0 to 1.
  std::vector<Vec3> curvature;
};

struct OrientationComb {
  std::vector<double> at;
  /// The angular velocity in space, radians for the whole range of the parameter: W = 2 vec(r' conj(r)) / |r|^2, so that
  /// the axes of the frame change by W x axis. Zero where r vanishes.
  std::vector<Vec3> velocity;
};

/// @param samples at least 2, at equal steps, both ends of the domain included, here and below
/// @throws Error InvalidParameter for fewer; Cancelled.
TrajectoryComb trajectoryComb(const Motion&, std::size_t samples, const Progress& = Progress::none());
ScalingComb scalingComb(const Motion&, CombAlong, double across, std::size_t samples, const Progress& = Progress::none());
OrientationComb orientationComb(const Motion&, CombAlong, double across, std::size_t samples,
                                const Progress& = Progress::none());

}  // namespace blossom::sweep
