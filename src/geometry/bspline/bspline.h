#pragma once
#include <span>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "geometry/bspline/curve.h"
#include "geometry/bspline/surface.h"

/// Operations on B-spline curves and surfaces with values in R^4. Numbers in brackets: Piegl & Tiller, The NURBS Book, 2nd
/// ed. Every function takes clamped and unclamped knot vectors alike unless it says otherwise, and expects what `validate`
/// accepts. A parameter outside the domain continues the first or the last piece. Hand-written because OCCT's splines end at
/// degree 25, where products of motions need more, and take 2.7 us a point where a grid of tabulated basis functions
/// (geometry/tessellate/surface_grid.h) takes 0.05 us.
namespace blossom {

/// Highest degree handled anywhere, also of products and elevated curves. OCCT and most formats stop at 25.
inline constexpr int kMaximumDegree = 60;

/// @throws Error InvalidInput saying what is wrong: degree below 1, sizes, decreasing knots, multiplicity above degree + 1,
/// an empty domain, values that are not finite. LimitExceeded above kMaximumDegree.
void validate(const Curve&);
void validate(const Surface&);

/// Index k with knots[k] <= t < knots[k+1] within the domain; the last non-empty span at its end. [A2.1] O(log n).
std::size_t findSpan(int degree, std::span<const double> knots, double t);
/// The degree + 1 non-zero basis functions at t and their derivatives up to `order`, row-major [order + 1][degree + 1]; they
/// belong to the poles span - degree .. span. [A2.3] O(p^2).
void basisDerivatives(int degree, std::span<const double> knots, std::size_t span, double t, int order,
                      std::span<double> out);

/// Homogeneous value; O(p^2).
Vec4 evaluate(const Curve&, double t);
Vec4 evaluate(const Surface&, double u, double v);
/// Homogeneous derivatives 0..order.
std::vector<Vec4> derivatives(const Curve&, double t, int order);
/// Homogeneous derivatives d^(i+j)/du^i dv^j at [i * (order + 1) + j] for i + j <= order.
std::vector<Vec4> derivatives(const Surface&, double u, double v, int order);

/// Point in R^3. @throws Error Degenerate where the weight vanishes.
Vec3 point(const Curve&, double t);
Vec3 point(const Surface&, double u, double v);
/// Point and first partial derivatives in R^3 (quotient rule).
struct SurfaceFrame {
  Vec3 point, du, dv;
};
SurfaceFrame frame(const Surface&, double u, double v);

/// Inserts each of `knots` (sorted, with repetitions) without changing the curve. Every new pole is a blossom at consecutive
/// new knots, a convex combination of old poles (Oslo algorithm, Cohen, Lyche & Riesenfeld 1980).
/// @throws Error InvalidInput when `knots` is not sorted, leaves the domain or exceeds multiplicity degree + 1.
Curve insertKnots(const Curve&, std::span<const double> knots);
Surface insertKnotsU(const Surface&, std::span<const double> knots);
Surface insertKnotsV(const Surface&, std::span<const double> knots);
/// Same shape under a knot vector with multiplicity degree + 1 at both ends of the domain.
Curve clamped(const Curve&);
Surface clamped(const Surface&);
/// Same shape, `times` degrees higher, clamped; continuity at the knots is kept. Every new pole averages blossoms of the old
/// curve (Prautzsch 1984), so that no digit is lost.
Curve elevateDegree(const Curve&, int times);
Surface elevateDegree(const Surface&, int timesU, int timesV);

/// Bézier pieces: for each non-empty span the degree + 1 poles, one after the other, and the distinct knots.
struct BezierCurve {
  int degree = 0;
  std::vector<double> breaks;  ///< spans + 1 values
  std::vector<Vec4> poles;     ///< spans * (degree + 1)
};
BezierCurve toBezier(const Curve&);
struct BezierSurface {
  int degreeU = 0, degreeV = 0;
  std::vector<double> breaksU, breaksV;
  std::vector<Vec4> poles;  ///< patch (a, b) starts at (a * spansV + b) * (degreeU+1) * (degreeV+1), u-major inside
};
BezierSurface toBezier(const Surface&);

/// Surface traced backwards in u, or with u and v exchanged.
Surface reversedU(const Surface&);
Surface transposed(const Surface&);
/// Iso-parametric curve.
Curve isoU(const Surface&, double u);
Curve isoV(const Surface&, double v);
/// Smallest weight (w component) of all poles.
double smallestWeight(const Curve&);
double smallestWeight(const Surface&);

}  // namespace blossom
