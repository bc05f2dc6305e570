#pragma once
#include <string>
#include <vector>

#include "geometry/values/color.h"

namespace blossom {

/// What the faces of shapes are drawn to tell about their surfaces.
enum class SurfaceDisplay {
  Plain,
  Zebra,      ///< the stripes of striped surroundings, mirrored
  Gaussian,   ///< Gaussian curvature in colours
  Mean,       ///< mean curvature in colours
  Largest,    ///< the larger |principal curvature| in colours
  IsoCurves,  ///< curves of constant parameter on plain faces
};
/// "plain", "zebra", "gaussian", "mean", "largest", "iso"; in the order of the enumeration.
const std::vector<std::string>& surfaceDisplayNames();
/// @throws Error InvalidParameter for another name.
SurfaceDisplay surfaceDisplayOf(const std::string& name);
[[nodiscard]] constexpr bool showsCurvature(SurfaceDisplay display) {
  return display == SurfaceDisplay::Gaussian || display == SurfaceDisplay::Mean || display == SurfaceDisplay::Largest;
}
/// The unit of the curvature that is shown: "1/mm" or "1/mm²".
const char* curvatureUnit(SurfaceDisplay);

struct ZebraLook {
  int stripes = 12;  ///< dark ones, from one side of the surroundings to the other
  double angle = 0;  ///< degrees by which they are turned from level, counter-clockwise as one sees them
};

/// The values at the two ends of a scale of colours.
struct CurvatureRange {
  double low = 0, high = 0;
  friend bool operator==(const CurvatureRange&, const CurvatureRange&) = default;
};
/// About zero where the sign counts; from zero for the largest curvature. @param bound above 0
CurvatureRange curvatureRange(SurfaceDisplay, double bound);

/// The colour at a place on the scale of a curvature, 0 at its low end and 1 at its high one. Blue is below zero, red above,
/// and flat is grey; the largest curvature runs from dark blue over green to yellow. Neighbours differ for eyes that tell no
/// red from green.
Color curvatureColor(SurfaceDisplay, double place);

}  // namespace blossom
