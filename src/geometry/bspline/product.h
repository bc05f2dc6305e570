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
/// so no digit is lost at any degree and for any knots. `fromBezier` is the fast way for many factors and few, multiple
/// knots (patch_polynomial.h).
namespace blossom {

/// One factor in one parameter direction.
struct ProductFactor {
  int degree = 0;             ///< p_i, as it enters continuity
  int times = 1;              ///< how often it enters the product's degree (2 for a factor that is squared)
  std::vector<double> knots;  ///< full vector, clamped or not
};
/// Knot vector of a product. At each distinct interior knot the multiplicity is P - min(p_i - m_i) over the factors that
/// have it.
struct ProductKnots {
  int degree = 0;             ///< P = sum of times * degree
  std::vector<double> knots;  ///< clamped full vector over the common domain
};
/// Knots of different factors closer than 1e-12 of the domain's length count as one: they were meant to be equal.
/// @throws Error InvalidInput when the domains differ or there are no factors; LimitExceeded when P passes kMaximumDegree.
ProductKnots productKnots(std::span<const ProductFactor> factors);

/// Component-wise product of two curves / two surfaces in R^4, clamped over the common domain; relative error some 1e-15.
/// O(n p q min(p, q)) for the weights, and (p + 1)(q + 1) products for each pole, squared for a surface.
/// @throws as productKnots.
Curve product(const Curve&, const Curve&);
Surface product(const Surface&, const Surface&);

/// B-spline poles from Bezier pieces over the same breaks, for a knot vector under which the pieces are smooth enough. Pole
/// i is the blossom at the knots i+1 .. i+p of the piece for which rounding errors grow least. They grow some 10 times when
/// knots are as multiple as in products of low degrees, about (p/e)^p times when they are simple (1e2 at degree 6, 1e6 at
/// 10).
/// @throws Error InvalidInput when sizes do not fit or a knot inside the breaks' range is no break.
Curve fromBezier(const BezierCurve&, std::span<const double> knots);
Surface fromBezier(const BezierSurface&, std::span<const double> knotsU, std::span<const double> knotsV);

}  // namespace blossom
