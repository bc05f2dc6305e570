#pragma once
#include "core/progress.h"
#include "geometry/planar/fitting/sampled_region.h"
#include "geometry/planar/polygons/snapped_operands.h"

namespace blossom::planar {

/// Two regions as polygons for their sum: each is cut at the normals of the other.
struct SampledPair {
  SampledRegion a, b;
  // Whether the edges of each are known to be farther apart than 2^-30 of its size, but for corners that are
  // exactly the same.
  bool clearA = false, clearB = false;
};

/// @param share of the tolerances
SampledPair sampledPair(const SoundRegion& a, const SoundRegion& b, double share, Sampling, const Progress&);

SampledPair sampledPair(const SoundSet& a, const SoundSet& b, double share, Sampling, const Progress&);

/// Finds out what is clear, in O(n log n): for pairs that are kept.
void certifyClear(SampledPair&, const Progress&);

/// The same pair as sampledPair makes of the multiples, for cuts depend on directions alone. @pre s > 0, t > 0
SampledPair scaled(const SampledPair&, double s, double t);

/// Both on the grids of their sum, as the convolution requires them, curves and points there and back.
SnappedOperands untangledTogether(const SampledPair&, const Progress&);

}  // namespace blossom::planar
