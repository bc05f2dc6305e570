#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/curve.h"
#include "geometry/bspline.h"
#include "geometry/surface.h"

/// Exact products of B-splines: Bézier extraction, convolution of scaled Bernstein coefficients, assembly of the B-spline poles by
/// blossoming; no linear system is solved (Farin, Curves and Surfaces, chapter on blossoms).
namespace blossom {

/// Knot vector of a product. At each distinct knot the multiplicity is P - min(p_i - m_i) over the factors that have that knot.
struct ProductFactor {
  int degree = 0;                  ///< p_i, as it enters continuity
  int times = 1;                   ///< how often it enters the product's degree (2 for a factor that is squared)
  std::vector<double> knots;       ///< full vector
};
struct ProductKnots {
  int degree = 0;                  ///< P = sum of times * degree
  std::vector<double> knots;       ///< clamped full vector over the common domain
};
/// @throws Error InvalidInput when the domains differ.
ProductKnots productKnots(std::span<const ProductFactor> factors);

/// Component-wise product of two curves / two surfaces in R^4, exact up to rounding (1e-14 relative).
Curve product(const Curve&, const Curve&);
Surface product(const Surface&, const Surface&);

/// B-spline poles from Bézier pieces over the same breaks, for a knot vector under which the pieces are smooth enough.
/// Pole i is the blossom at the knots i+1 .. i+p.
Curve fromBezier(const BezierCurve&, std::span<const double> knots);
Surface fromBezier(const BezierSurface&, std::span<const double> knotsU, std::span<const double> knotsV);

}  // namespace blossom
