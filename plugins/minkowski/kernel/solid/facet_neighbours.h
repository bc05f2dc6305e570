#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/solid/loft_facets.h"

namespace blossom::minkowski {

/// For every facet that may bound the facets that may touch it, ascending, without itself; for others nothing. What is apart
/// in one of four directions both at the bottom and at the top is apart everywhere between. O(n^2), on all cores.
std::vector<std::vector<int>> facetNeighbours(std::span<const LoftFacet>, const Progress&);

}  // namespace blossom::minkowski
