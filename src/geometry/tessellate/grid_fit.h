#pragma once
#include "geometry/tessellate/surface_grid.h"
#include "geometry/tessellate/tessellate.h"

/// Grids that are fine enough for a tessellation.
namespace blossom {

/// Which code makes the triangles at the border of a grid.
enum class GridBorder {
  Own,    ///< the grid itself; samples at knots with a possible kink are doubled
  Shared  ///< the code that joins neighbouring faces: there are at least two steps in either direction, no sample is
          ///< doubled, and cells at the border satisfy the chord with either diagonal
};

/// A grid whose cells, divided along `mainDiagonal`, satisfy the chord and whose normals turn by at most the angle from row
/// to row. Every knot span has its own number of steps in either direction.
/// @throws Error LimitExceeded above 2^24 grid points, Degenerate, Cancelled.
SurfaceGrid fitGrid(const Surface&, const TessellationOptions&, GridBorder, const Progress&);

/// Whether the diagonal of a cell runs from (0,0) to (1,1): the shorter diagonal makes the better triangles.
inline bool mainDiagonal(const Vec3& p00, const Vec3& p10, const Vec3& p01, const Vec3& p11) {
  return (p11 - p00).squaredNorm() <= (p01 - p10).squaredNorm();
}

}  // namespace blossom
