#pragma once
#include "core/progress.h"
#include "geometry/bspline/patch_polynomial.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

struct ProductOptions {
  int refinements = 6;  ///< maximum number of knot insertions to make every weight positive, and small ones larger
};

struct ProductResult {
  Surface
      surface;  ///< poles (X, Y, Z, W), clamped; scaled by a power of two so that the largest weight is between 1/2 and 1
  double smallestWeight = 0;  ///< of the poles; the largest is between 1/2 and 1
  int refinements = 0;        ///< number of knot insertions
};

/// Degrees and knots of the product, and the patches between them. @throws as productKnots; LimitExceeded above 2^24
/// coefficients of all patches together, before any memory is taken.
PatchGrid productGrid(const Motion&);

/// The coefficients of the denominator W = tw |r|^2 sw alone, as all components of a surface over the product's knots: about
/// a fifth of the work of productSurface, and before any knot insertion. @throws as productGrid; Cancelled.
Surface weightCoefficients(const Motion&, const Progress& = Progress::none());

/// The swept surface as one rational B-spline surface with the parameters of the motion, x(u,v) = M(u,v) p exactly (Yoon &
/// Lee 2009, section 3; the paper's r21 lacks its factor 2). With d = |r|^2 and y = Q(r) (sx px, sy py, sz pz): X = tw y +
/// (tx, ty, tz) d sw, W = tw d sw. Degrees 2 ru + su and tv + 2 rv + sv: 9 and 12 for cubics. A closed motion results in a
/// surface over one period with equal first and last rows of poles. Weights that are not positive are made positive by knot
/// insertion (the coefficients converge to W > 0). So are those that are so only by rounding, and twice at most those below
/// 1/100 of the largest that quaternions nearly cancel in: their poles lie far away and have few digits. Quaternions of
/// other lengths, whose weights differ as much, are left as they are.
/// @throws Error Degenerate where the quaternions vanish or weights stay negative; LimitExceeded above degree 25 and where
/// knot insertion makes too many patches; as productGrid; Cancelled.
ProductResult productSurface(const Motion&, const ProductOptions& = {}, const Progress& = Progress::none());

}  // namespace blossom::sweep
