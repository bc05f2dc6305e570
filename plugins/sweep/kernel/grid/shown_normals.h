#pragma once
#include "kernel/grid/grid_range.h"
#include "kernel/grid/motion_grid.h"

/// Normals for shading. Where the surface runs into a point, or its sections do along a stretch of v, it has no normal; it
/// is shaded as at the nearest column that has one.
namespace blossom::sweep {

/// Zero only where the whole row has no normal. O(1) where there is one.
Vec3 shownNormal(const MotionGrid&, std::size_t k, std::size_t l);

/// The columns that a change of `part` may show in: also those beside it, without normals of their own, that borrow them.
GridRectangle withBorrowers(const MotionGrid&, GridRectangle part);

}  // namespace blossom::sweep
