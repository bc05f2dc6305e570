#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/scheme.h"

namespace blossom::subdivision {

/// No refined mesh gets more faces than this.
inline constexpr double kMostFaces = 4e6;

struct SubdivideOptions {
  Scheme scheme = Scheme::CatmullClark;
  int levels = 2;      ///< 0 or more; every level has four times the faces
  bool limit = false;  ///< vertices are moved to the limit surface
};

struct SubdivideResult {
  Mesh mesh;                      ///< carries the sharpness that is left, so that refining it goes on where this stopped
  std::size_t limitSurfaces = 0;  ///< faces whose limit surface was needed for limit points without an exact mask
};

/// The cage refined `levels` times, edges and vertices sharp as its tags say (DeRose, Kass & Truong 1998). Limit points are
/// those of the exact limit masks; at vertices that are still semi-sharp, or of polygons
/// that are no quads, those of the surface isolated ten levels deep. Where a sharp crease ends inside, the smooth mask is an
/// approximation.
/// O(faces * 4^levels).
/// @throws Error InvalidInput (see checkCage), LimitExceeded, Cancelled.
SubdivideResult subdivide(const Mesh& cage, const SubdivideOptions&, const Progress& = Progress::none());

}  // namespace blossom::subdivision
