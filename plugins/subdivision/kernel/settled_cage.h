#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::subdivision {

/// A cage of quads whose edges and vertices are either infinitely sharp or smooth.
struct SettledCage {
  Mesh quads;
  double sharpened = 0;  ///< mm, maximum distance of its limit surface from that of the cage, measured at equal parameters
};

/// Refines a cage until the rest of semi-sharp edges and vertices can be made sharp within the tolerance: an edge of
/// sharpness s is rounded over about 2^-s of a face. O(faces of the result).
/// @pre `checkCage` accepts the cage. @throws Error LimitExceeded when that would be too many faces, Cancelled.
SettledCage settledCage(const Mesh& cage, double tolerance, const Progress& = Progress::none());

}  // namespace blossom::subdivision
