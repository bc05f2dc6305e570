#pragma once
#include <string>
#include <vector>

#include "geometry/shape/shape.h"

namespace blossom {

struct NamedShape {
  std::string name;
  Shape shape;
};

/// Kind of the result of `mergedShape`: curves for drawings, mesh for meshes, a B-rep assembly for shapes with an exact
/// form. None when the kinds cannot be combined: a motion, or a mesh with exact shapes.
ShapeKind mergedKind(const std::vector<ShapeKind>&);

/// Combines shapes into one, for a file that stores them all; a single shape is returned as it is. Nothing is joined or cut.
/// An assembly keeps the names; so does a single mesh or B-rep, and each frame of a sequence, where it has none of its own.
/// O(size of meshes and drawings); B-reps are shared.
/// @throws Error InvalidInput when mergedKind is None.
Shape mergedShape(const std::vector<NamedShape>&);

}  // namespace blossom
