#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/place.h"

namespace blossom::morphology {

struct CheckedSolid {
  Mesh triangles;  ///< closed, outward, no triangle without area, crossing nowhere
  std::vector<std::string> warnings;
};

/// A mesh as the boundary of a solid: what can be mended without a guess is (faces that all look inwards, triangles without
/// area, bodies that overlap each other), the rest is refused by its place.
/// @throws Error InvalidInput for an empty, open, non-manifold, twisted or self-crossing mesh and for coordinates that are
/// no numbers; LimitExceeded for coordinates beyond 1e9 mm.
CheckedSolid checkedSolid(const Mesh&, const Subject& subject, const Progress& = Progress::none());

/// Only what can be told without exact arithmetic: numbers, indices, size. @throws Error.
void refuseRubbish(const Mesh&, const Subject& subject);

}  // namespace blossom::morphology
