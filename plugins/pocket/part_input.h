#pragma once
#include <gp_Trsf.hxx>

#include <string>
#include <vector>

#include "feature/feature_type.h"
#include "geometry/planar/region.h"

namespace blossom::pocket {

/// The planar part of a feature's input.
struct Part {
  Region region;
  gp_Trsf placing;  ///< from the plane of the region to the position of the part; identity unless it was a face
  bool fromFace = false;
  bool looksUp = false;  ///< the face is horizontal and faces up: x and y of the region are those of the solid ..
  double height = 0;     ///< .. and the face is at this height
  std::vector<std::string> warnings;  ///< full sentences
};

/// The input of a part: a region, closed curves, or a flat face of a B-rep, chosen by `face`; -1 means the only flat face or
/// the sheets of a drawing.
InputSpec partInput(std::string asks);
ParameterSpec partFace();
inline constexpr const char* partFaceHelp = "The flat face to use as the part when the input is a solid.";

/// Treatment of open lines, such as centre lines and dimensions of a drawing.
enum class OpenLines {
  Refuse,
  RefuseForNow,  ///< refuse, and suggest the flag of the feature that leaves them out
  LeaveOut
};
inline constexpr const char* skipOpenHelp = "Leaves out lines that do not close, with a warning, instead of refusing them.";

/// Transforms a face to its own plane, seen from outside the solid; a face that faces up keeps its x and y.
/// @throws Error InvalidInput (open curves, a face that is not flat, a solid without a face chosen), NotFound.
Part partOf(const Shape&, const SubShapeValue& face, OpenLines = OpenLines::Refuse);

}  // namespace blossom::pocket
