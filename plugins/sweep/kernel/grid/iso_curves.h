#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Iso-parametric curves of a swept surface as polylines.
struct IsoCurves {
  std::vector<std::vector<Vec3>> constantU;  ///< x(u, .), one for each u asked for
  std::vector<std::vector<Vec3>> constantV;  ///< x(., v), one for each v asked for
};

/// @param us,vs parameters in the domain at which there is to be a curve  @param samples points of each curve, at least 2,
/// at equal steps of the other parameter, both ends of the domain included. O(curves * samples), as fast per point as
/// evaluateGrid.
/// @throws Error InvalidParameter for fewer than 2 samples; Cancelled.
IsoCurves isoCurves(const Motion&, std::span<const double> us, std::span<const double> vs, std::size_t samples,
                    const Progress& = Progress::none());

}  // namespace blossom::sweep
