#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/shape/motion.h"
#include "kernel/fold.h"

namespace blossom::sweep {

/// Distance of a swept surface from degeneracy.
struct Validity {
  double smallestNormal = 0;  ///< mm^2 per unit of u and v, smallest |x_u cross x_v| found
  double smallestShare = 0;   ///< that divided by the largest of the samples; 0: the surface folds or collapses
  double u = 0, v = 0;        ///< parameters of the minimum
  Vec3 place{0, 0, 0};        ///< where it is in space, mm
  std::optional<Fold> fold;   ///< between neighbouring samples, also the finer ones; none at an edge, however sharp
};

/// Samples 8 x 8 points of every span of the motion, and its ends; fewer of a motion of very many spans, so that they are no
/// more than 4 million. Around samples smaller than their neighbours, the least
/// of them first and 32 at most, finer samples are taken, until the normal vanishes or gets no smaller: a point through
/// which the surface passes, or a line along which it folds, lies between the samples as a rule. Of the folds of a surface
/// that is closed both ways, one where its sections go back counts before others. O(samples), about 20 ns each, and 3 ms;
/// and 25 points for each of the places at which neighbouring normals point away from each other. @throws Error Cancelled.
Validity examine(const Motion&, const Progress& = Progress::none());

/// Checks that the motion sweeps a surface, and no line or point: somewhere among 4 x 4 samples of every span, x_u cross x_v
/// is longer than rounding explains. @throws Error Degenerate with what to do; Cancelled.
void requireArea(const Motion&, const Progress& = Progress::none());

/// The smallest coefficient of W, the denominator of the swept surface: above 0, W is positive everywhere (convex hull).
struct SmallestWeight {
  double weight = 0;    ///< scaled by a power of two so that the largest is between 1/2 and 1, as productSurface does
  double u = 0, v = 0;  ///< Greville abscissae of the coefficient, near which it has the most influence
  Vec3 place{0, 0, 0};  ///< the swept point there, mm
};

/// Computes W = tw |r|^2 sw alone (Yoon & Lee 2009, section 3), about a fifth of the work of productSurface, and before any
/// knot insertion: at or below 0 productSurface would insert knots or refuse. Of equal coefficients the first in u and then
/// in v counts.
/// @throws as productKnots; Error Degenerate where all coefficients vanish or overflow; Cancelled.
SmallestWeight smallestProductWeight(const Motion&, const Progress& = Progress::none());

/// The same of the weights of a surface that was made from the motion, knots inserted or not: those that are exported.
/// @throws Error Degenerate where all weights vanish or overflow.
SmallestWeight smallestWeightOf(const Surface&, const Motion&);

}  // namespace blossom::sweep
