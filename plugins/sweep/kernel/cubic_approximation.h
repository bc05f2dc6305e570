#pragma once
#include <cstddef>

#include "core/progress.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

struct CubicOptions {
  double tolerance = 1e-3;          ///< mm, maximum distance from x(u,v) at equal parameters
  std::size_t maximumSpans = 1024;  ///< maximum number of spans in each direction
};

struct CubicResult {
  Surface surface;       ///< polynomial (all weights 1), bicubic, clamped; first and last row equal when closed in u
  double deviation = 0;  ///< mm, maximum distance measured at 8 x 8 samples in every span and on its edges
  std::size_t spansU = 0, spansV = 0;
};

/// A bicubic B-spline approximation of the swept surface, for receivers that cannot read rational surfaces of high degree.
/// It interpolates the motion at its breaks and is C2 wherever the motion is, but C1 at the seam of a closed motion that is
/// not C2 all around; the spans of the motion are halved until the measured deviation is at most the tolerance.
/// @throws Error LimitExceeded with the deviation reached; Degenerate; Cancelled. O(samples), about 20 ns each.
CubicResult approximateCubic(const Motion&, const CubicOptions& = {}, const Progress& = Progress::none());

/// Maximum distance at equal parameters between the motion and a surface, at samples x samples points of each span and on
/// its edges. Returns early once the distance exceeds `enough`.
double deviation(const Motion&, const Surface&, int samples, double enough, const Progress& = Progress::none());

}  // namespace blossom::sweep
