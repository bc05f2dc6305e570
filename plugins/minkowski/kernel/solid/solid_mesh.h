#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/solid/loft_scene.h"

namespace blossom::minkowski {

/// Where the places of a loft are in space.
struct LoftPlacement {
  Grid bottom, top;  ///< of one unit
  double height = 1;
  [[nodiscard]] Vec3 point(const LoftPredicates::Place&) const;
};

/// Closed polygons from the sides of the faces. Faces that lie within `tolerance` of one plane beside one another are one,
/// and so are corners that near; a face with a hole, or that touches itself, comes as some triangles. Where the solid
/// touches itself along an edge, that edge has four faces. O(n log n).
/// @throws Error Internal when the sides do not close, Cancelled.
Mesh meshOfSides(std::span<const LoftSide>, const LoftPlacement&, double tolerance, const Progress&);

}  // namespace blossom::minkowski
