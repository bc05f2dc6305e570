#include "kernel/region_sum.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.h"
#include "kernel/curves/curved_sum.h"
#include "kernel/flattening.h"
#include "kernel/polygon_sum.h"

namespace blossom::minkowski {
namespace {

/// Shape i as the operand of a sum or difference.
template <class Operand>
using MakeOperand = Operand (*)(const Region&, const FlatteningOptions&, const std::string& name, const Progress&);

/// @param sides where the polygons of the first and of the other shapes may lie
template <class Operand>
std::vector<Operand> operands(std::span<const Region> regions, const RegionSumOptions& options,
                              std::pair<Approximation, Approximation> sides, MakeOperand<Operand> make, Effort& effort,
                              const Progress& progress) {
  if (regions.size() < 2)
    throw Error(ErrorCode::InvalidParameter, "A Minkowski sum or difference needs two shapes.", "Give another shape.");
  std::vector<Operand> result;
  for (std::size_t i = 0; i < regions.size(); ++i)
    result.push_back(make(regions[i],
                          {.tolerance = options.tolerance,
                           .share = 1.0 / static_cast<double>(regions.size()),
                           .side = i == 0 ? sides.first : sides.second,
                           .effort = &effort},
                          fmt::format("shape {}", i + 1), progress));
  return result;
}

template <class Operand>
using Operation = Operand (*)(const Operand&, const Operand&, const Progress&, Effort&);

/// The first shape with the others, one after the other.
template <class Operand>
Operand folded(const std::vector<Operand>& shapes, const Progress& progress, Effort& effort, Operation<Operand> operation) {
  Operand total = shapes.front();
  const auto count = static_cast<double>(shapes.size() - 1);
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    const auto before = static_cast<double>(i - 1);
    progress.report(before / count, "Adding shapes");
    effort.expect(shapes.size() - i);
    total = operation(total, shapes[i], progress.part(before / count, (before + 1) / count), effort);
  }
  return total;
}

double smallestDefault(std::span<const Region> regions) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Region& region : regions) smallest = std::min(smallest, defaultTolerance(region));
  return smallest;
}

}  // namespace

RegionSumResult minkowskiSum(std::span<const Region> regions, const RegionSumOptions& options, const Progress& progress) {
  Effort effort(options.maximumWork);
  const auto shapes =
      operands<SoundRegion>(regions, options, {Approximation::Either, Approximation::Either}, soundRegion, effort, progress);
  return {folded<SoundRegion>(shapes, progress, effort, sum).region, shapes.size() - 1, {}};
}

// Lines and arcs where that is all there is, else polygons on the safe side of the curves.
Region roomInside(std::span<const Region> regions, const RegionSumOptions& options, const Progress& progress) {
  Effort effort(options.maximumWork);
  const auto shapes =
      operands<SoundRegion>(regions, options, {Approximation::Either, Approximation::Either}, soundRegion, effort, progress);
  if (std::all_of(shapes.begin(), shapes.end(), [](const SoundRegion& shape) { return shape.plain; }))
    return folded<SoundRegion>(shapes, progress, effort, difference).region;
  const auto polygons =
      operands<Polygons>(regions, options, {Approximation::Inside, Approximation::Outside}, flattened, effort, progress);
  return toRegion(folded<Polygons>(polygons, progress, effort, difference));
}

RegionSumResult minkowskiDifference(std::span<const Region> regions, const RegionSumOptions& options,
                                    const Progress& progress) {
  RegionSumResult result{roomInside(regions, options, progress), regions.size() - 1, {}};
  const bool curved = std::any_of(regions.begin(), regions.end(), hasCurves);
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

RegionSumResult regionOpening(const Region& a, const Region& b, const RegionSumOptions& options, const Progress& progress) {
  const RegionSumResult room = minkowskiDifference(std::vector{a, b}, options, progress.part(0, 0.5));
  RegionSumResult result = minkowskiSum(std::vector{room.region, b}, options, progress.part(0.5, 1));
  result.sums += room.sums;
  result.warnings = room.warnings;
  return result;
}

RegionSumResult regionClosing(const Region& a, const Region& b, const RegionSumOptions& options, const Progress& progress) {
  const RegionSumResult grown = minkowskiSum(std::vector{a, b}, options, progress.part(0, 0.5));
  RegionSumResult result = minkowskiDifference(std::vector{grown.region, b}, options, progress.part(0.5, 1));
  result.sums += grown.sums;
  return result;
}

}  // namespace blossom::minkowski
