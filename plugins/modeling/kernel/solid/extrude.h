#pragma once
#include <TopoDS_Shape.hxx>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom::modeling {

struct ExtrudeOptions {
  double height = 20;       ///< mm along the normal (or `direction`); negative: against it
  double back = 0;          ///< mm the other way as well
  double taper = 0;         ///< degrees by which the sides lean inwards, both ways from the outline; negative: outwards
  Vec3 direction{0, 0, 0};  ///< zero: square to the outline
};

struct ExtrudeResult {
  TopoDS_Shape shape;  ///< solids over the faces of the profile (united where leaning makes them overlap), sheets over wires
  bool solid = false;
};

/// Moves flat faces and wires along a line. With a taper each side becomes the exact plane or cone through its edge; sides
/// over free-form edges cannot lean.
/// @throws Error InvalidInput, InvalidParameter (nothing to move along), Degenerate (a taper so strong that sides meet).
ExtrudeResult extrude(const TopoDS_Shape& profile, const ExtrudeOptions&, const Progress& = Progress::none());

}  // namespace blossom::modeling
