#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Curvatures of a swept surface on a grid of parameters. Entry (k, l) has index k * countV + l, as in MotionGrid.
struct GridCurvature {
  std::size_t countU = 0, countV = 0;
  std::vector<double> gaussian;  ///< K in 1/mm^2; zero where the normal vanishes
  /// H in 1/mm, with respect to x_u cross x_v: a sphere of radius a whose normal points outwards has -1/a. Zero where the
  /// normal vanishes.
  std::vector<double> mean;
};

/// Gaussian and mean curvature from the exact first and second derivatives of the factors. Both are invariant under
/// rotations, so the fundamental forms are computed in the moving frame: with a = s p / sw and the angular velocities
/// W_u = 2 vec(conj(r) r_u) / |r|^2 (W_v alike), R^T x_u = a_u + W_u x a, R^T x_uu = a_uu + W_uu x a + W_u x (2 a_u + W_u x
/// a), and so on; the trajectory adds R^T t' and R^T t''. Then K = (L N - M^2) / (E G - F^2), H = (E N - 2 F M + G L) / (2
/// (E G - F^2)) (do Carmo, Differential Geometry of Curves and Surfaces, section 3-3). At a knot the piece to the right
/// counts. O(us * vs * degreeU), single-threaded; about 60 ns per point. Reuses the memory of the result.
/// @throws Error Cancelled.
void evaluateCurvature(const Motion&, std::span<const double> us, std::span<const double> vs, GridCurvature& result,
                       const Progress& = Progress::none());

}  // namespace blossom::sweep
