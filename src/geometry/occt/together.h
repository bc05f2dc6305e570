#pragma once
#include <string>
#include <vector>

#include "geometry/shape/shape.h"

namespace blossom {

struct NamedShape {
  std::string name;
  Shape shape;
};

/// Of what kind shapes are when they are taken together: drawings become curves, meshes a mesh, and anything that has an
/// exact form one assembly. None when they cannot be: a motion, or a mesh beside exact shapes.
ShapeKind kindTogether(const std::vector<ShapeKind>&);

/// Shapes as one, for a file that holds them all; a single one stays what it is. Nothing is joined or cut. An assembly keeps
/// the names. O(size of meshes and drawings); B-reps are shared.
/// @throws Error InvalidInput when kindTogether is None.
Shape together(const std::vector<NamedShape>&);

}  // namespace blossom
