#pragma once
#include "core/progress.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Distance of a swept surface from degeneracy.
struct Validity {
  double smallestNormal = 0;  ///< mm^2 per unit of u and v, minimum |x_u cross x_v| of the samples
  double smallestShare = 0;   ///< that divided by the maximum; 0: the surface folds or collapses
  double u = 0, v = 0;        ///< parameters of the minimum
};

/// Samples 8 x 8 points of every span of the motion, and its ends. O(samples), about 20 ns each. @throws Error Cancelled.
Validity examine(const Motion&, const Progress& = Progress::none());

}  // namespace blossom::sweep
