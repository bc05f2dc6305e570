#include "kernel/region_sum.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.h"
#include "kernel/flattening.h"
#include "kernel/polygon_sum.h"

namespace blossom::minkowski {
namespace {

/// @param sides where the polygons of the first and of the other shapes may lie
std::vector<Polygons> operands(std::span<const Region> regions, const RegionSumOptions& options,
                               std::pair<Approximation, Approximation> sides, Effort& effort, const Progress& progress) {
  if (regions.size() < 2)
    throw Error(ErrorCode::InvalidParameter, "A Minkowski sum or difference needs two shapes.", "Give another shape.");
  std::vector<Polygons> result;
  for (std::size_t i = 0; i < regions.size(); ++i)
    result.push_back(flattened(regions[i],
                               {.tolerance = options.tolerance,
                                .share = 1.0 / static_cast<double>(regions.size()),
                                .side = i == 0 ? sides.first : sides.second,
                                .effort = &effort},
                               fmt::format("shape {}", i + 1), progress));
  return result;
}

using Operation = Polygons (*)(const Polygons&, const Polygons&, const Progress&, Effort&);

RegionSumResult folded(std::span<const Region> regions, const RegionSumOptions& options,
                       std::pair<Approximation, Approximation> sides, const Progress& progress, Operation operation) {
  Effort effort(options.maximumWork);
  const std::vector<Polygons> shapes = operands(regions, options, sides, effort, progress);
  Polygons total = shapes.front();
  const auto count = static_cast<double>(shapes.size() - 1);
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    const auto before = static_cast<double>(i - 1);
    progress.report(before / count, "Adding shapes");
    effort.expect(shapes.size() - i);
    total = operation(total, shapes[i], progress.part(before / count, (before + 1) / count), effort);
  }
  return {toRegion(total), shapes.size() - 1, {}};
}

double smallestDefault(std::span<const Region> regions) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Region& region : regions) smallest = std::min(smallest, defaultTolerance(region));
  return smallest;
}

}  // namespace

RegionSumResult minkowskiSum(std::span<const Region> regions, const RegionSumOptions& options, const Progress& progress) {
  return folded(regions, options, {Approximation::Either, Approximation::Either}, progress, sum);
}

RegionSumResult minkowskiDifference(std::span<const Region> regions, const RegionSumOptions& options,
                                    const Progress& progress) {
  RegionSumResult result = folded(regions, options, {Approximation::Inside, Approximation::Outside}, progress, difference);
  const bool curved = std::any_of(regions.begin(), regions.end(), isCurved);
  const double tolerance = options.tolerance.value_or(smallestDefault(regions));
  if (result.region.loops.empty())
    throw Error(ErrorCode::Degenerate,
                curved ? fmt::format("Nothing is left: within {:.2g} mm, shape 1 has no room for the other.", tolerance)
                       : "Nothing is left: shape 1 has no room for the other.",
                "Make shape 1 larger, or what is taken away smaller.");
  constexpr double wide = 50;
  if (curved && thicknessOf(result.region) < wide * tolerance)
    result.warnings.push_back(
        fmt::format("The room is hardly wider than the tolerance, {:.2g} mm, by which curves are drawn: it is larger than "
                    "told, and a smaller tolerance shows more of it.",
                    tolerance));
  return result;
}

}  // namespace blossom::minkowski
