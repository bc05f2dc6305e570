#pragma once
#include "core/progress.h"
#include "geometry/bspline/surface.h"
#include "geometry/mesh/mesh.h"

namespace blossom::subdivision {

struct FacesOptions {
  double tolerance = 0.01;  ///< mm, maximum distance of faces from the limit surface near extraordinary points
};

struct FacesResult {
  std::vector<Surface> faces;  ///< bicubic, not rational; adjacent along whole sides
  std::size_t exactFaces = 0;  ///< number of faces that represent the limit surface exactly, C2
  double deviation = 0;        ///< mm, maximum measured distance between faces and limit surface at equal parameters
  double sharpened = 0;        ///< mm, the part of it caused by semi-sharp edges made sharp
  double normalDeviation = 0;  ///< radians, maximum angle between their normals, away from such edges
};

/// The limit surface of a Catmull-Clark cage as few bicubic B-spline faces. The cage is divided into rectangles
/// (quadLayout). Rectangles without extraordinary corners have uniform knots and are exact. Towards an extraordinary corner
/// knots are inserted at 1/2, 1/4, .. of the face, which makes all pieces but the last exact too, because the L-shaped rings
/// around the corner are polynomial (Stam, Exact Evaluation of Catmull-Clark Subdivision Surfaces, SIGGRAPH 1998). The last
/// piece, at least 1/256 of a face, interpolates the limit point, the tangent plane, and points on its sides and inside.
/// Adjacent faces share their boundary curves, so that they close. Semi-sharp edges are refined until making the rest sharp
/// causes at most half of the tolerance.
/// @throws Error InvalidInput (see checkCage), LimitExceeded when semi-sharp edges require too many faces, Cancelled.
FacesResult bsplineFaces(const Mesh& cage, const FacesOptions& = {}, const Progress& = Progress::none());

}  // namespace blossom::subdivision
