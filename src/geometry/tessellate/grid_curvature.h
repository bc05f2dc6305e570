#pragma once
#include <vector>

#include "core/progress.h"
#include "geometry/bspline/surface.h"
#include "geometry/tessellate/surface_grid.h"
#include "geometry/values/surface_curvature.h"

namespace blossom {

/// First and second derivatives in space (quotient rule), of the piece to the right at a knot.
SurfaceJet jetOf(const Surface&, double u, double v);

/// Curvatures at every sample of a grid, with respect to the normal along du x dv, from the second derivatives of the
/// surface: at a kink, of each side. Where a tangent vanishes, as at a pole, those of a place a little inside count; 0 where
/// there are none either. u-major, as the points of the grid. O(p q) per row and O(q) per point, in parallel.
/// @throws Error Cancelled.
std::vector<SurfaceCurvature> gridCurvature(const Surface&, const SurfaceGrid&, const Progress&);

}  // namespace blossom
