#pragma once
#include "geometry/tessellate/surface_grid.h"
#include "geometry/tessellate/tessellate.h"

/// Grids fine enough for a tessellation.
namespace blossom {

/// Who makes the triangles at the border of a grid.
enum class GridBorder {
  Own,    ///< the grid; knots where there may be a kink come twice
  Shared  ///< whoever joins it to a neighbour's points: there are at least two steps in either direction, every knot comes
          ///< once, and cells at the border keep within the chord whichever way they are cut
};

/// The grid whose cells, cut along `mainDiagonal`, keep within the chord and whose normals turn by the angle at most from
/// row to row. Every span of knots has its own number of steps in either direction.
/// @throws Error LimitExceeded when the grid would have more than 2^24 points, Degenerate, Cancelled.
SurfaceGrid fitGrid(const Surface&, const TessellationOptions&, GridBorder, const Progress&);

/// Does the diagonal of a cell run from (0,0) to (1,1)? The shorter one makes the better triangles.
inline bool mainDiagonal(const Vec3& p00, const Vec3& p10, const Vec3& p01, const Vec3& p11) {
  return (p11 - p00).squaredNorm() <= (p01 - p10).squaredNorm();
}

}  // namespace blossom
