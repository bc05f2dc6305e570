#pragma once
#include <cmath>
#include <optional>

#include "core/vector.h"

namespace blossom {

/// How a surface bends at a point, seen from the side that its normal points to.
struct SurfaceCurvature {
  double gaussian = 0;  ///< product of the principal curvatures, 1/mm^2
  double mean = 0;  ///< half their sum, 1/mm; above 0 where the surface bulges towards the viewer: 1/r on a ball of radius r
  double spread = 0;  ///< half their difference, 1/mm, 0 or more

  [[nodiscard]] double largest() const { return std::abs(mean) + spread; }  ///< the larger |principal curvature|
};

/// First and second derivatives of a surface in space, mm.
struct SurfaceJet {
  Vec3 u, v, uu, uv, vv;
};

/// Curvatures with respect to the normal along u x v. The second fundamental form is written in an orthonormal basis of the
/// tangent plane, so the difference of the principal curvatures has no cancellation: the spread of a sphere is 0 up to
/// rounding, not up to its root (do Carmo, Differential Geometry of Curves and Surfaces, section 3-3, has the mean of the
/// other sign). Empty where the two tangents are parallel or one vanishes. O(1).
std::optional<SurfaceCurvature> curvatureOf(const SurfaceJet&);

}  // namespace blossom
