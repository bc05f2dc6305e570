#include "kernel/region_sum.h"

#include <fmt/format.h>

#include "core/error.h"
#include "kernel/flattening.h"
#include "kernel/polygon_sum.h"

namespace blossom::minkowski {
namespace {

std::vector<Polygons> operands(std::span<const Region> regions, double tolerance, const Progress& progress) {
  if (regions.size() < 2)
    throw Error(ErrorCode::InvalidParameter, "A Minkowski sum or difference needs two shapes.", "Give another shape.");
  std::vector<Polygons> result;
  for (std::size_t i = 0; i < regions.size(); ++i)
    result.push_back(
        flattened(regions[i], tolerance / static_cast<double>(regions.size()), fmt::format("shape {}", i + 1), progress));
  return result;
}

template <class Operation>
RegionSumResult folded(std::span<const Region> regions, const RegionSumOptions& options, const Progress& progress,
                       Operation operation) {
  const std::vector<Polygons> shapes = operands(regions, options.tolerance, progress);
  Polygons total = shapes.front();
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    progress.report(static_cast<double>(i) / static_cast<double>(shapes.size()), "Adding shapes");
    total = operation(total, shapes[i], progress);
  }
  return {toRegion(total), shapes.size() - 1};
}

}  // namespace

RegionSumResult minkowskiSum(std::span<const Region> regions, const RegionSumOptions& options, const Progress& progress) {
  return folded(regions, options, progress, sum);
}

RegionSumResult minkowskiDifference(std::span<const Region> regions, const RegionSumOptions& options,
                                    const Progress& progress) {
  RegionSumResult result = folded(regions, options, progress, difference);
  if (result.region.loops.empty())
    throw Error(ErrorCode::Degenerate, "Nothing is left: shape 1 has no room for the other.",
                "Make shape 1 larger, or what is taken away smaller.");
  return result;
}

}  // namespace blossom::minkowski
