#pragma once
#include <cstddef>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

struct MotionMeshOptions {
  std::size_t cells = 6;  ///< in each direction of every span between the knots of the factors
};

/// How many cells of two triangles the mesh of a motion has. O(knots log knots).
std::size_t cellsOfMesh(const Motion&, const MotionMeshOptions&);

/// Triangles of the swept surface, evaluated from the factors: the product surface is not formed. Corners lie on the surface
/// at the same parameters for all motions with the same knots; seams are joined, and triangles that are a line are left out.
/// O(spans * cells^2), about 50 ns for a cell. @throws Error Degenerate where the orientation vanishes, LimitExceeded above
/// 2^22 cells, Cancelled.
Mesh motionMesh(const Motion&, const MotionMeshOptions& = {}, const Progress& = Progress::none());

}  // namespace blossom::sweep
