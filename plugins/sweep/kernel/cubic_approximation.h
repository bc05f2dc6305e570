#pragma once
#include <cstddef>

#include "core/progress.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

struct CubicOptions {
  double tolerance = 1e-3;  ///< mm, maximum distance from x(u,v) at equal parameters
  /// Spans are halved up to this number in each direction; a motion that has more keeps those that it has.
  std::size_t maximumSpans = 1024;
};

struct CubicResult {
  Surface surface;  ///< polynomial (all weights 1), bicubic, clamped; first and last row equal when closed in u, columns in
                    ///< a smooth ring
  double deviation = 0;  ///< mm, maximum distance measured at 8 x 8 samples in every span and on its edges
  std::size_t spansU = 0, spansV = 0;
};

/// A bicubic B-spline approximation of the swept surface, for receivers that cannot read rational surfaces of high degree.
/// It interpolates the motion at its breaks and is C2 wherever the motion is, but at a seam in u, and at one in v of a
/// motion that closes there (kernel/edit/seam_v.h), only when the poles and knots of every factor say that it is C2 there
/// and the motion is C2 all along; else it is C1 there. The spans of the motion are halved until the measured deviation is
/// at most the tolerance.
/// @throws Error LimitExceeded with the deviation reached; Degenerate; Cancelled. O(samples), about 20 ns each.
CubicResult approximateCubic(const Motion&, const CubicOptions& = {}, const Progress& = Progress::none());

/// Maximum distance at equal parameters between the motion and a surface, at samples x samples points of each span and on
/// its edges. Returns early once the distance exceeds `enough`.
double deviation(const Motion&, const Surface&, int samples, double enough, const Progress& = Progress::none());

}  // namespace blossom::sweep
