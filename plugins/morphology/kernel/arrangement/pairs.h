#pragma once
#include <array>
#include <vector>

#include "core/progress.h"
#include "kernel/arrangement/features.h"

namespace blossom::morphology::arrangement {

/// Features of two shapes, by their numbers, whose directions come near enough to each other to make facets of a sum.
struct FeaturePairs {
  using Pair = std::array<int, 2>;
  std::vector<Pair> facesAndCorners;  ///< a face of the first shape, a corner of the second
  std::vector<Pair> cornersAndFaces;  ///< a corner of the first, a face of the second
  std::vector<Pair> edges;
};

/// The outward directions of faces, of the planes that support corners, and of those that support edges, as points, cones
/// and arcs on the sphere, met in trees of boxes. All pairs that the DHS test can accept are among them, also when corners
/// of the shapes move by up to `rounding` steps: factors that scale the shapes do not turn their directions, only rounding
/// does. About O((n + m) log n + pairs). @throws Error Cancelled.
FeaturePairs nearPairs(const Features& a, const Features& b, double rounding, const Progress&);

}  // namespace blossom::morphology::arrangement
