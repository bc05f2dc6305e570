#include "kernel/solid/facet_neighbours.h"

#include <algorithm>
#include <array>

#include "core/parallel.h"

namespace blossom::minkowski {
namespace {

/// The ranges of x, y, x + y and x - y at the bottom and at the top.
struct FacetReach {
  std::array<std::int64_t, 8> low, high;
};

FacetReach reachOf(const LoftFacet& facet) {
  FacetReach reach{};
  for (const std::size_t end : {0, 1}) {
    const GridPoint &p = facet.from[end], &q = facet.to[end];
    const std::array<std::int64_t, 4> ofP{p.x, p.y, p.x + p.y, p.x - p.y}, ofQ{q.x, q.y, q.x + q.y, q.x - q.y};
    for (std::size_t k = 0; k < 4; ++k) {
      reach.low[4 * end + k] = std::min(ofP[k], ofQ[k]);
      reach.high[4 * end + k] = std::max(ofP[k], ofQ[k]);
    }
  }
  return reach;
}

bool mayTouch(const FacetReach& a, const FacetReach& b) {
  for (std::size_t k = 0; k < 4; ++k) {
    if (a.high[k] < b.low[k] && a.high[k + 4] < b.low[k + 4]) return false;
    if (b.high[k] < a.low[k] && b.high[k + 4] < a.low[k + 4]) return false;
  }
  return true;
}

}  // namespace

std::vector<std::vector<int>> facetNeighbours(std::span<const LoftFacet> facets, const Progress& progress) {
  std::vector<FacetReach> reaches;
  reaches.reserve(facets.size());
  for (const LoftFacet& facet : facets) reaches.push_back(reachOf(facet));
  std::vector<std::vector<int>> neighbours(facets.size());
  parallelFor(facets.size(), 16, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      progress.check();
      if (!facets[i].mayBound) continue;
      for (std::size_t k = 0; k < facets.size(); ++k)
        if (k != i && mayTouch(reaches[i], reaches[k])) neighbours[i].push_back(static_cast<int>(k));
    }
  });
  return neighbours;
}

}  // namespace blossom::minkowski
