#include "kernel/region_sum.h"

#include <fmt/format.h>

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
  return {toRegion(total), shapes.size() - 1};
}

}  // namespace

RegionSumResult minkowskiSum(std::span<const Region> regions, const RegionSumOptions& options, const Progress& progress) {
  return folded(regions, options, {Approximation::Either, Approximation::Either}, progress, sum);
}

RegionSumResult minkowskiDifference(std::span<const Region> regions, const RegionSumOptions& options,
                                    const Progress& progress) {
  RegionSumResult result = folded(regions, options, {Approximation::Inside, Approximation::Outside}, progress, difference);
  if (result.region.loops.empty())
    throw Error(ErrorCode::Degenerate, "Nothing is left: shape 1 has no room for the other.",
                "Make shape 1 larger, or what is taken away smaller.");
  return result;
}

}  // namespace blossom::minkowski
