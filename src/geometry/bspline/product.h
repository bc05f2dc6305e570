#pragma once
#include <span>
#include <vector>

#include "geometry/bspline/bspline.h"
#include "geometry/bspline/curve.h"
#include "geometry/bspline/surface.h"

/// Exact products of B-splines by blossoming; no linear system is solved, as BSplCLib::FunctionMultiply of OCCT does, which
/// interpolates the product.
///
/// `product` symmetrises the product of the factors' blossoms (Ramshaw, "Blossoms are polar forms", 1989; Moerken, "Some
/// identities for products and degree raising of splines", 1991): every pole is a convex combination of products of poles,
/// so there is no loss of accuracy at any degree and for any knots. `fromBezier` is faster for many factors with few,
/// multiple knots (patch_polynomial.h).
namespace blossom {

/// One factor in one parameter direction.
struct ProductFactor {
  int degree = 0;             ///< p_i, which determines the continuity at its knots
  int times = 1;              ///< exponent of the factor (2 when it is squared)
  std::vector<double> knots;  ///< full vector, clamped or not
};
/// Knot vector of a product. The multiplicity of each distinct interior knot is P - min(p_i - m_i) over the factors that
/// contain it.
struct ProductKnots {
  int degree = 0;             ///< P = sum of times * degree
  std::vector<double> knots;  ///< clamped full vector over the common domain
};
/// The distinct knots of a product, ends included, and how many times it can be differentiated there: min(p_i - m_i) over
/// the factors that contain it, and -1 at the ends.
struct ProductBreaks {
  int degree = 0;
  std::vector<double> at;
  std::vector<int> continuity;  ///< one for each of `at`
};
/// Of any degree, as long as nobody forms the product. Knots of different factors that differ by less than 1e-12 of the
/// domain's length are treated as equal. @throws Error InvalidInput when the domains differ or there are no factors.
ProductBreaks productBreaks(std::span<const ProductFactor> factors);

/// Knots of different factors that differ by less than 1e-12 of the domain's length are treated as equal.
/// @throws Error InvalidInput when the domains differ or there are no factors; LimitExceeded when P exceeds kMaximumDegree.
ProductKnots productKnots(std::span<const ProductFactor> factors);

/// Component-wise product of two curves / two surfaces in R^4, clamped over the common domain; relative error some 1e-15.
/// O(n p q min(p, q)) for the weights, and (p + 1)(q + 1) products for each pole, squared for a surface.
/// @throws as productKnots.
Curve product(const Curve&, const Curve&);
Surface product(const Surface&, const Surface&);

/// B-spline poles of Bezier pieces over the same breaks, for a knot vector whose multiplicities match the smoothness of the
/// pieces. Pole i is the blossom at the knots i+1 .. i+p of the piece with the smallest growth of rounding errors: about 10
/// times for knots as multiple as in products of low degrees, about (p/e)^p times for simple knots (1e2 at degree 6, 1e6 at
/// 10).
/// @throws Error InvalidInput when sizes do not match or a knot inside the range of the breaks is no break.
Curve fromBezier(const BezierCurve&, std::span<const double> knots);
Surface fromBezier(const BezierSurface&, std::span<const double> knotsU, std::span<const double> knotsV);

}  // namespace blossom
