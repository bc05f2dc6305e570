#pragma once
#include <TopoDS_Shape.hxx>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom::modeling {

struct ExtrudeOptions {
  double height = 20;       ///< mm along the normal (or `direction`); negative: in the opposite direction
  double back = 0;          ///< mm in the opposite direction, in addition
  double taper = 0;         ///< degrees, inward inclination of the sides in both directions; negative: outward
  Vec3 direction{0, 0, 0};  ///< zero: perpendicular to the outline
};

struct ExtrudeResult {
  TopoDS_Shape shape;  ///< solids for the faces of the profile (united where a taper makes them overlap), sheets for wires
  bool solid = false;
};

/// Extrudes planar faces and wires along a line. With a taper each side is the exact plane or cone through its edge; sides
/// of free-form edges cannot be tapered.
/// @throws Error InvalidInput, InvalidParameter (zero length), Degenerate (the taper makes sides meet).
ExtrudeResult extrude(const TopoDS_Shape& profile, const ExtrudeOptions&, const Progress& = Progress::none());

/// The unit vector along which the first face of a profile, or its first wire, is extruded. @throws Error as extrude.
Vec3 directionOf(const TopoDS_Shape& profile, const ExtrudeOptions&);

}  // namespace blossom::modeling
