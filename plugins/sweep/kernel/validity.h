#pragma once
#include "core/progress.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// How far a swept surface is from trouble.
struct Validity {
  double smallestNormal = 0;  ///< mm^2 per unit of u and v, smallest |x_u cross x_v| of the samples
  double smallestShare = 0;   ///< that over the largest one; 0: the surface folds or collapses
  double u = 0, v = 0;        ///< where
};

/// Samples 8 x 8 places of every span of the motion, and its ends. O(samples), about 20 ns each. @throws Error Cancelled.
Validity examine(const Motion&, const Progress& = Progress::none());

}  // namespace blossom::sweep
