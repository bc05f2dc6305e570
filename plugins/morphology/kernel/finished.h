#pragma once
#include <string>

#include "core/progress.h"
#include "kernel/exact.h"

namespace blossom::morphology {

/// A result with its corners rounded to doubles.
struct Finished {
  Mesh mesh;            ///< closed polygons in the user's coordinates; no two cross, by the exact test
  std::string warning;  ///< when corners had to be moved by more than rounding
};

/// The solid as polygons: triangles of one plane joined, straight edges thinned (see joinedFacesFlatness). Where rounding
/// makes faces cross, fewer are joined; where they still do, corners are put on coarser and coarser grids.
/// The same solid gives the same mesh, however it was triangulated.
/// @throws Error Degenerate with the place when faces cross on every grid, Internal, Cancelled.
Finished finished(const Solid&, const Vec3& centre, const Progress&);

/// The same from closed, oriented triangles about `centre`.
Finished finished(const Mesh& triangles, const Vec3& centre, const Progress&);

}  // namespace blossom::morphology
