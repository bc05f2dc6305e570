#pragma once
#include <gp_Trsf.hxx>

#include <string>
#include <vector>

#include "feature/feature_type.h"
#include "geometry/planar/region.h"

namespace blossom::pocket {

/// The planar part that a feature works on.
struct Part {
  Region region;
  gp_Trsf placing;  ///< from the plane of the region to where the part stands; identity unless it was a face
  bool fromFace = false;
  bool looksUp = false;               ///< the face, so that x and y of the region are those of the solid ..
  double height = 0;                  ///< .. and the face lies at this height
  std::vector<std::string> warnings;  ///< full sentences
};

/// A part comes in as a region, closed curves, or a flat face of a B-rep. `face` says which one; -1 takes the only flat face
/// or the sheets of a drawing.
InputSpec partInput();
ParameterSpec partFace();
inline constexpr const char* partFaceHelp = "The flat face that is the part when the input is a solid.";

/// What becomes of lines that do not close, such as centre lines and dimensions of a drawing.
enum class OpenLines {
  Refuse,
  RefuseForNow,  ///< the feature has the flag that leaves them out
  LeaveOut
};
inline constexpr const char* skipOpenHelp = "Lines that do not close are left out, and told, instead of refused.";

/// The face is brought into its own plane, seen from outside the solid; a face that looks up keeps its x and y.
/// @throws Error InvalidInput (open curves, a face that is not flat, a solid without a face chosen), NotFound.
Part partOf(const Shape&, const SubShapeValue& face, OpenLines = OpenLines::Refuse);

}  // namespace blossom::pocket
