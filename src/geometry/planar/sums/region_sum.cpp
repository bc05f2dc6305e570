#include "geometry/planar/sums/region_sum.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/sums/curved_sum.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/polygon_sum.h"
#include "geometry/planar/sums/shared_sides.h"

namespace blossom::planar {
namespace {

/// Shape i as the operand of a sum or difference.
template <class Operand>
using MakeOperand = Operand (*)(const Region&, const FlatteningOptions&, const std::string& name, const Progress&);

[[noreturn]] void refuseOneShape() {
  throw Error(ErrorCode::InvalidParameter, "A Minkowski sum or difference needs two shapes.", "Give another shape.");
}

/// @param sides where the polygons of the first and of the other shapes may lie
template <class Operand>
std::vector<Operand> operands(std::span<const Region> regions, const RegionSumOptions& options,
                              std::pair<Approximation, Approximation> sides, MakeOperand<Operand> make, Effort& effort,
                              const Progress& progress) {
  if (regions.size() < 2) refuseOneShape();
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

/// Those with a weight other than 0, as large as it makes them.
std::vector<SoundRegion> weighted(std::span<const Region> regions, const RegionSumOptions& options, Effort& effort,
                                  const Progress& progress) {
  std::vector<SoundRegion> result;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const double weight = weightOf(options, i);
    SoundRegion shape = soundRegion(regions[i],
                                    {.tolerance = options.tolerance,
                                     .share = 1.0 / (static_cast<double>(regions.size()) * std::max(1.0, std::abs(weight))),
                                     .effort = &effort},
                                    fmt::format("shape {}", i + 1), progress);
    if (weight != 0) result.push_back(weight == 1 ? std::move(shape) : scaled(shape, weight));
  }
  return result;
}

double smallestDefault(std::span<const Region> regions) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Region& region : regions) smallest = std::min(smallest, defaultTolerance(region));
  return smallest;
}

bool hasLines(const Region& region) {
  return std::any_of(region.loops.begin(), region.loops.end(), [](const Path& loop) {
    return std::any_of(loop.segments.begin(), loop.segments.end(),
                       [](const Segment& segment) { return std::holds_alternative<Line2>(segment); });
  });
}

}  // namespace

double weightOf(const RegionSumOptions& options, std::size_t i) {
  return i < options.weights.size() ? options.weights[i] : 1;
}

void checkSummands(std::size_t shapes, const RegionSumOptions& options) {
  if (shapes < 2) refuseOneShape();
  if (options.weights.size() > shapes)
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("{} weights are given for {} shapes.", options.weights.size(), shapes),
                "Leave out those too many.");
  for (std::size_t i = 0; i < shapes; ++i)
    if (weightOf(options, i) != 0) return;
  throw Error(ErrorCode::InvalidParameter, "All weights are 0: the origin alone is left, which has no area.",
              "Give a shape a weight other than 0.");
}

RegionSumResult minkowskiSum(std::span<const Region> regions, const RegionSumOptions& options, const Progress& progress) {
  checkSummands(regions.size(), options);
  Effort effort(options.maximumWork);
  const std::vector<SoundRegion> shapes = weighted(regions, options, effort, progress);
  RegionSumResult result{folded<SoundRegion>(shapes, progress, effort, sum).region, shapes.size() - 1, {}};
  bool splines = false;
  for (std::size_t i = 0; i < regions.size(); ++i)
    splines = splines || (weightOf(options, i) != 0 && hasSplines(regions[i]));
  warnOfLines(splines, result.region, options.tolerance, result.warnings);
  return result;
}

// Polygons on the safe side of curves that touching loops have made lines.
Region roomInside(std::span<const Region> regions, const RegionSumOptions& options, const Progress& progress) {
  Effort effort(options.maximumWork);
  const auto shapes =
      operands<SoundRegion>(regions, options, {Approximation::Either, Approximation::Either}, soundRegion, effort, progress);
  const auto asDrawn = [](const SoundRegion& shape) { return shape.plain || hasSplines(shape.region); };
  if (std::all_of(shapes.begin(), shapes.end(), asDrawn))
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
  if (result.region.loops.empty()) {
    result.warnings.push_back(nothingLeft(curved ? std::optional(tolerance) : std::nullopt));
    return result;
  }
  constexpr double wide = 50;
  // Lines and arcs that come of true ones are as they are.
  const bool asDrawn =
      hasCurves(result.region) && (!hasLines(result.region) || std::any_of(regions.begin(), regions.end(), hasLines));
  if (curved && !asDrawn && thicknessOf(result.region) < wide * tolerance)
    result.warnings.push_back(
        fmt::format("The room is hardly wider than the tolerance, {:.2g} mm, by which curves are drawn: it is larger than "
                    "told, and a smaller tolerance shows more of it.",
                    tolerance));
  if (hasCurves(result.region)) return result;
  // Splines between two of its parts bound nothing.
  const Region first = withoutSharedSides(regions.front(), tolerance, progress).without.value_or(regions.front());
  warnOfLines(splinesBoundRoom(first, std::any_of(regions.begin() + 1, regions.end(), hasSplines)), result.region, tolerance,
              result.warnings);
  return result;
}

bool splinesBoundRoom(const Region& area, bool splinesFit) {
  if (hasSplines(area)) return true;
  if (!splinesFit) return false;
  if (hasCurves(area)) return true;
  Region first = area;
  for (Path& loop : first.loops)
    if (signedArea(loop) < 0) loop = reversed(loop);
  return !isConvex(SoundRegion{std::move(first)});
}

void warnOfLines(bool hasCurvesOfShapes, const Region& result, const std::optional<double>& tolerance,
                 std::vector<std::string>& warnings) {
  if (!hasCurvesOfShapes || result.loops.empty() || hasCurves(result)) return;
  warnings.push_back(
      fmt::format("Free-form curves came out as straight lines, within {} of the curves; a smaller tolerance makes "
                  "them finer.",
                  tolerance ? fmt::format("{:.2g} mm", *tolerance) : "the tolerance"));
}

std::string nothingLeft(std::optional<double> toleranceOfCurves) {
  return fmt::format(
      "Nothing is left: {}shape 1 has no room for the other. Make shape 1 larger, or what is taken away smaller.",
      toleranceOfCurves ? fmt::format("within {:.2g} mm, ", *toleranceOfCurves) : std::string());
}

}  // namespace blossom::planar
