#pragma once
#include <gp_Trsf.hxx>

#include <optional>

#include "feature/feature_type.h"
#include "geometry/region.h"

namespace blossom::pocket {

/// The planar part that a feature works on.
struct Part {
  Region region;
  gp_Trsf placing;  ///< from the plane of the region to where the part stands; identity unless it was a face
  bool fromFace = false;
};

/// A part comes in as a region, closed curves, or a flat face of a B-rep. `face` says which one; -1 takes the only flat face
/// or the sheets of a drawing.
InputSpec partInput();
ParameterSpec partFace();
inline constexpr const char* partFaceHelp = "The flat face that is the part when the input is a solid.";

/// The face is brought into its own plane, seen from outside the solid; a face that looks up keeps its x and y.
/// @throws Error InvalidInput (open curves, a face that is not flat, a solid without a face chosen), NotFound.
Part partOf(const Shape&, const SubShapeValue& face);

}  // namespace blossom::pocket
