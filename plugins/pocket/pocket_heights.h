#pragma once
#include <string>
#include <vector>

#include "geometry/values/box.h"
#include "kernel/path/obstacle.h"
#include "part_input.h"

namespace blossom::pocket {

/// What the face of a solid is to the pocket.
enum class FaceIs { Automatic, Top, Floor };

/// Heights of a pocket over z = 0, where the path begins to cut: the part's top, or where a pocket opens whose floor was
/// picked.
struct PocketHeights {
  double depth = 0;     ///< mm, of the pocket
  double face = 0;      ///< height of the face
  double above = 0;     ///< mm that the solid rises above z = 0; rapids across keep above it
  double bottom = 0;    ///< height of the solid's lowest point; 0 without a solid
  Bounds box;           ///< around the solid; empty without one
  Triangles triangles;  ///< the solid
  double chord = 0;     ///< mm that they may be off
};

struct HeightsWanted {
  double depth = 0;  ///< mm, when the face is the pocket's top
  FaceIs faceIs = FaceIs::Automatic;
  double tolerance = 0.005;
};

/// Measures the solid that a face belongs to. A face all of whose outer boundary is walled is a floor; the pocket then goes
/// from where these walls end down to it. @throws Error InvalidInput when a floor is asked for and no wall rises around it.
PocketHeights heightsOf(const Shape&, const SubShapeValue& face, const Part&, const HeightsWanted&,
                        std::vector<std::string>& warnings, const Progress&);

/// @throws Error InvalidInput with the place when the path would hit what stands over the face.
void refuseHits(const Toolpath&, const PocketHeights&, const Part&, double tolerance, const Progress&);

}  // namespace blossom::pocket
