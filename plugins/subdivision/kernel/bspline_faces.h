#pragma once
#include "core/progress.h"
#include "geometry/bspline/surface.h"
#include "geometry/mesh/mesh.h"

namespace blossom::subdivision {

struct FacesOptions {
  double tolerance = 0.01;  ///< mm that faces may lie off the limit surface near extraordinary points
};

struct FacesResult {
  std::vector<Surface> faces;  ///< bicubic, without weights; they meet side to side
  std::size_t exactFaces = 0;  ///< of them, faces that are the limit surface itself, twice continuously differentiable
  double deviation = 0;        ///< mm, largest distance measured between faces and limit surface at equal parameters
  double sharpened = 0;        ///< mm, the share in it of semi-sharp edges that became sharp
  double normalDeviation = 0;  ///< radians, largest angle between their normals, away from such edges
};

/// The limit surface of a Catmull-Clark cage as few bicubic B-spline faces. The cage is cut into rectangles (quadLayout).
/// Rectangles without extraordinary corners have uniform knots and are exact. At an extraordinary corner knots lie at 1/2,
/// 1/4, .. of the face there, which makes all but the last of its pieces exact too (Stam, Exact Evaluation of Catmull-Clark
/// Subdivision Surfaces, SIGGRAPH 1998, tells why: the L-shaped rings round the corner are polynomial); the last piece, a
/// 256th of a face at the smallest, takes the limit point, the tangent plane, and the middles of its sides and its inside
/// from the limit surface. Faces meet in the same curves, so that they close. Semi-sharp edges are refined until what is
/// left of them can be sharp within half of the tolerance.
/// @throws Error InvalidInput (see checkCage), LimitExceeded when semi-sharp edges ask for too many faces, Cancelled.
FacesResult bsplineFaces(const Mesh& cage, const FacesOptions& = {}, const Progress& = Progress::none());

}  // namespace blossom::subdivision
