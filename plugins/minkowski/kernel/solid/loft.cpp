#include "kernel/solid/loft.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/planar/polygons/snapped_operands.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/winding/snap_rounding.h"
#include "kernel/solid/facet_neighbours.h"
#include "kernel/solid/level_edges.h"
#include "kernel/solid/solid_mesh.h"
#include "kernel/solid/upright_edges.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

constexpr double nearness = 1e-10;  // of the size, within which corners are one

/// The sides of all faces, in the order of the facets whatever the number of cores.
std::vector<LoftSide> sidesOfFaces(const LoftScene& scene, const Effort& effort, const Progress& progress) {
  const std::size_t count = scene.loft.facets.size();
  std::vector<std::vector<LoftSide>> ofFacet(count);
  std::atomic<double> work = 0;
  std::atomic<std::size_t> done = 0;
  parallelFor(count, 4, progress, [&](std::size_t begin, std::size_t end) {
    UprightEdges upright(scene);
    LevelEdges level(scene);
    for (std::size_t i = begin; i < end; ++i) {
      if (!scene.loft.facets[i].mayBound) continue;
      const double before = upright.work();
      upright.find(static_cast<int>(i), ofFacet[i], progress);
      level.find(static_cast<int>(i), ofFacet[i], progress);
      effort.foresee(work += upright.work() - before);
      progress.report(static_cast<double>(++done) / static_cast<double>(count), "Resolving the solid");
    }
  });
  std::vector<LoftSide> all;
  for (const auto& sides : ofFacet) all.insert(all.end(), sides.begin(), sides.end());
  return all;
}

/// Corners that are one within rounding of the height must not be those of an outline.
void refuseTooHigh(const Polygons& a, const Polygons& b, double height) {
  constexpr double highest = 1e6;
  const double width = std::min(boxOf(a).sizes().maxCoeff(), boxOf(b).sizes().maxCoeff());
  if (height <= highest * width) return;
  throw Error(
      ErrorCode::InvalidParameter,
      fmt::format("The height of the solid, {:.4g} mm, is more than a million times the size of an outline, {:.4g} mm.",
                  height, width),
      "Give a smaller height, or larger outlines.");
}

}  // namespace

LoftResult loft(const Polygons& a, const Polygons& b, double height, const Progress& progress, Effort& effort) {
  refuseTooHigh(a, b, height);
  const SnappedOperands operands = snappedTogether(a, b);
  progress.report(0, "Pairing edges");
  const LoftFacets facets =
      loftFacets(untangled(operands.a, progress), untangled(operands.b, progress), progress.part(0, 0.05));
  effort.foresee(Effort::pairsOfEdge * static_cast<double>(facets.facets.size()));
  const LoftPredicates predicates(facets.facets);
  const auto neighbours = facetNeighbours(facets.facets, progress.part(0.05, 0.1));
  std::vector<LoftTime> levels;
  for (const LoftLevel& level : facets.levels) levels.push_back(timeOf(level));
  const std::vector<LoftSide> sides =
      sidesOfFaces({facets, predicates, neighbours, levels}, effort, progress.part(0.1, 0.95));
  const double size = std::max({boxOf(a).sizes().maxCoeff(), boxOf(b).sizes().maxCoeff(), height});
  return {meshOfSides(sides, {operands.gridA, operands.gridB, height}, nearness * size, progress.part(0.95, 1)),
          facets.facets.size()};
}

LoftResult loft(const Region& a, const Region& b, const LoftOptions& options, const Progress& progress) {
  if (!(options.height > 0) || !std::isfinite(options.height))
    throw Error(ErrorCode::InvalidParameter, fmt::format("The height of the solid is {} mm.", options.height),
                "Give a height above 0.");
  Effort effort(options.maximumWork);
  const FlatteningOptions flattening{.tolerance = options.tolerance, .effort = &effort};
  const Polygons lower = flattened(a, flattening, "shape 1", progress),
                 upper = flattened(b, flattening, "shape 2", progress);
  return loft(lower, upper, options.height, progress, effort);
}

}  // namespace blossom::minkowski
