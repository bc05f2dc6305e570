#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::subdivision {

/// A cage of quads only, whose edges and vertices are sharp for ever or not at all.
struct SettledCage {
  Mesh quads;
  double sharpened = 0;  ///< mm that its limit surface lies off that of the cage at most, measured at equal parameters
};

/// Refines a cage as few times as are needed for what is left of semi-sharp edges and vertices to be made sharp within the
/// tolerance: one of sharpness s is rounded by about a 2^s-th of a face. O(faces of the result).
/// @pre `checkCage` accepts the cage. @throws Error LimitExceeded when that would be too many faces, Cancelled.
SettledCage settledCage(const Mesh& cage, double tolerance, const Progress& = Progress::none());

}  // namespace blossom::subdivision
