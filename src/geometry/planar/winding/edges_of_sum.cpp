#include "geometry/planar/winding/edges_of_sum.h"

#include <optional>

#include "geometry/planar/winding/certain_inside.h"

namespace blossom::planar {

std::vector<CountedEdge> edgesOfSum(std::span<const GridPolygon> a, std::span<const GridPolygon> b, Inside inside,
                                    const Progress& progress, const Effort& effort, PairSources* sources) {
  std::optional<CertainInside> leftOut;
  if (inside == Inside::Positive) leftOut = certainInside(a, b, Progress(progress.token()), effort);
  if (leftOut) {
    constexpr double fewPairs = 1e6;
    const bool isKept = leftOut->pairs() > fewPairs;
    std::vector<CountedEdge> edges =
        convolution(a, b, isKept ? progress : Progress(progress.token()), effort, sources, &*leftOut);
    // Much of what closes the cycles again is longer than what it stands for, and crosses more.
    if (isKept || 2 * static_cast<double>(edges.size()) < leftOut->pairs()) return edges;
    if (sources) sources->all = {PairSources::Pair()};
  }
  return convolution(a, b, progress, effort, sources);
}

}  // namespace blossom::planar
