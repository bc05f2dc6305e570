#pragma once
#include <gp_Trsf.hxx>

#include <string>

#include "core/progress.h"
#include "geometry/shape/shape.h"
#include "geometry/values/box.h"
#include "kernel/path/obstacle.h"

namespace blossom::pocket {

/// The solid around one of its flat faces, in the coordinates of the face: it lies at z = 0, with the outside of the solid
/// above.
struct SolidAround {
  Triangles triangles;    ///< the whole solid, within `chord`
  Bounds box;             ///< around them
  bool enclosed = false;  ///< walls rise all around the outer boundary of the face: it is the floor of a pocket
  double opening = 0;     ///< mm, height of the highest of these walls above the face
};

/// @param toFace from the solid to the coordinates of the face  @param chord mm, of the triangles
/// @throws Error NotFound, Cancelled.
SolidAround solidAround(const Brep&, int face, const gp_Trsf& toFace, double chord, const Progress&);

}  // namespace blossom::pocket
