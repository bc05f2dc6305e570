#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/scheme.h"

namespace blossom::subdivision {

/// Maximum number of faces of a refined mesh.
inline constexpr double kMaximumFaces = 4e6;

struct SubdivideOptions {
  Scheme scheme = Scheme::CatmullClark;
  int levels = 2;      ///< 0 or more; every level multiplies the faces by four
  bool limit = false;  ///< move vertices to the limit surface
};

struct SubdivideResult {
  Mesh mesh;                      ///< with the remaining sharpness, so that refining it further continues the subdivision
  std::size_t limitSurfaces = 0;  ///< faces whose limit surface was evaluated for limit points without an exact mask
};

/// Refines the cage `levels` times with the sharp edges and vertices of its tags (DeRose, Kass & Truong 1998). Limit points
/// are computed by the exact limit masks; at vertices that are still semi-sharp, or at corners of polygons that are no
/// quads, from the surface subdivided ten levels. Where a sharp crease ends inside, the smooth mask is an approximation.
/// O(faces * 4^levels).
/// @throws Error InvalidInput (see checkCage), LimitExceeded, Cancelled.
SubdivideResult subdivide(const Mesh& cage, const SubdivideOptions&, const Progress& = Progress::none());

}  // namespace blossom::subdivision
