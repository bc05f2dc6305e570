#include "kernel/edges_of_sum.h"

#include <optional>

#include "kernel/winding/certain_inside.h"

namespace blossom::minkowski {

std::vector<CountedEdge> edgesOfSum(std::span<const GridPolygon> a, std::span<const GridPolygon> b, const Progress& progress,
                                    const Effort& effort, PairSources* sources) {
  const std::optional<CertainInside> inside = certainInside(a, b, Progress(progress.token()), effort);
  if (inside) {
    constexpr double fewPairs = 1e6;
    const bool isKept = inside->pairs() > fewPairs;
    std::vector<CountedEdge> edges =
        convolution(a, b, isKept ? progress : Progress(progress.token()), effort, sources, &*inside);
    // Much of what closes the cycles again is longer than what it stands for, and crosses more.
    if (isKept || 2 * static_cast<double>(edges.size()) < inside->pairs()) return edges;
    if (sources) sources->all = {PairSources::Pair()};
  }
  return convolution(a, b, progress, effort, sources);
}

}  // namespace blossom::minkowski
