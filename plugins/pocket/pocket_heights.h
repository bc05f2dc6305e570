#pragma once
#include <string>
#include <vector>

#include "geometry/values/box.h"
#include "kernel/path/obstacle.h"
#include "part_input.h"

namespace blossom::pocket {

/// Role of the picked face of a solid.
enum class FaceIs { Automatic, Top, Floor };

/// Heights of a pocket relative to z = 0, where the path begins to cut: the top of the part or, when a floor was picked, the
/// opening of the pocket.
struct PocketHeights {
  double depth = 0;     ///< mm, of the pocket
  double face = 0;      ///< height of the face
  double above = 0;     ///< mm, height of the solid above z = 0; rapids across stay above it
  double bottom = 0;    ///< height of the solid's lowest point; 0 without a solid
  Bounds box;           ///< around the solid; empty without one
  Triangles triangles;  ///< the solid
  double chord = 0;     ///< mm, maximum distance of the triangles from the solid
};

struct HeightsWanted {
  double depth = 0;  ///< mm, when the face is the pocket's top
  FaceIs faceIs = FaceIs::Automatic;
  double tolerance = 0.005;
};

/// Measures the solid of a face. A face whose outer boundary is completely walled is a floor; the pocket then extends from
/// the top of these walls down to it. @throws Error InvalidInput when a floor is required and no wall rises around it.
PocketHeights heightsOf(const Shape&, const SubShapeValue& face, const Part&, const HeightsWanted&,
                        std::vector<std::string>& warnings, const Progress&);

/// @throws Error InvalidInput with the place when the path would hit the solid above the face.
void refuseHits(const Toolpath&, const PocketHeights&, const Part&, double tolerance, const Progress&);

}  // namespace blossom::pocket
