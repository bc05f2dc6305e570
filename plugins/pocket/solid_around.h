#pragma once
#include <gp_Trsf.hxx>

#include <string>

#include "core/progress.h"
#include "geometry/shape/shape.h"
#include "geometry/values/box.h"
#include "kernel/path/obstacle.h"

namespace blossom::pocket {

/// What stands around a flat face of a solid, in the coordinates of the face: it lies at z = 0, the solid's outside above.
struct SolidAround {
  Triangles triangles;    ///< all of the solid, within `chord`
  Bounds box;             ///< around them
  bool enclosed = false;  ///< the walls rise all around the face's outer boundary: it is the floor of a pocket
  double opening = 0;     ///< mm above the face, where the highest of these walls ends
};

/// @param toFace from the solid to the coordinates of the face  @param chord mm, of the triangles
/// @throws Error NotFound, Cancelled.
SolidAround solidAround(const Brep&, int face, const gp_Trsf& toFace, double chord, const Progress&);

}  // namespace blossom::pocket
