#include "kernel/compare/morph_comparison.h"

#include <fmt/format.h>

#include <utility>

#include "core/error.h"
#include "core/stopwatch.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/sums/flattening.h"
#include "kernel/compare/distance_field.h"
#include "kernel/compare/matched_outlines.h"
#include "kernel/morph/control_centre.h"
#include "kernel/morph/control_placement.h"
#include "kernel/morph/morph.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

constexpr std::size_t fewestCells = 8, mostCells = 1000;

void checkComparison(const ComparisonOptions& options) {
  if (options.times.empty())
    throw Error(ErrorCode::InvalidParameter, "A comparison needs a time at which shapes are compared.", "Give one or more.");
  if (options.resolution < fewestCells)
    throw Error(ErrorCode::InvalidParameter, fmt::format("Distance fields of {} cells are too coarse.", options.resolution),
                "Give at least 8.");
  if (options.resolution > mostCells)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("Distance fields have at most 1000 cells along their longer side; {} "
                            "are wanted.",
                            options.resolution),
                "Give at most 1000.");
}

/// A shape about its centroid, as it is and as polygons.
struct Centred {
  Region region;
  Polygons polygons;
};

Centred centred(const Region& region, const ComparisonOptions& options, const std::string& name, const Progress& progress) {
  const Polygons polygons = flattened(region, {.tolerance = options.tolerance}, name, progress);
  const double tolerance = options.tolerance.value_or(defaultTolerance(region));
  Placement placement;
  placement.offset = -centroid(region, tolerance);
  return {placed(region, placement), translated(polygons, placement.offset)};
}

Path pathOf(const Loop& loop) {
  Path path;
  path.closed = true;
  for (std::size_t i = 0; i < loop.size(); ++i) path.segments.emplace_back(Line2{loop[i], loop[(i + 1) % loop.size()]});
  return path;
}

void addLoops(MorphedWay& way, const std::vector<Loop>& loops) {
  std::vector<Path>& paths = way.outlines.emplace_back();
  double& area = way.areas.emplace_back(0);
  for (const Loop& loop : loops) {
    paths.push_back(pathOf(loop));
    area += signedArea(loop);
  }
}

void bySums(MorphComparison& result, const Centred& a, const Centred& b, const ComparisonOptions& options,
            const Progress& progress) {
  const Stopwatch watch;
  std::vector<std::vector<double>> arguments;
  for (const double t : options.times) arguments.push_back(diagonal(1, t));
  MorphResult morphed = morph(std::vector{a.region, b.region}, arguments,
                              {.tolerance = options.tolerance, .maximumWork = options.maximumWork}, progress);
  result.sums.milliseconds = watch.elapsedMs();
  result.sumCount = morphed.sums;
  for (Region& region : morphed.regions) {
    result.sums.areas.push_back(area(region));
    result.sums.outlines.push_back(std::move(region.loops));
  }
}

void byFields(MorphComparison& result, const Centred& a, const Centred& b, const ComparisonOptions& options,
              const Progress& progress) {
  const Stopwatch watch;
  const FieldGrid grid = fieldGrid(result.room, options.resolution);
  // A node takes about as long as comparing so many pairs of edges for its distances, and one for each in-between.
  constexpr std::size_t pairsOfNode = 128;
  Effort(options.maximumWork).spend((pairsOfNode + options.times.size()) * grid.nodes());
  const std::vector<double> first = signedDistances(a.polygons, grid, progress),
                            second = signedDistances(b.polygons, grid, progress);
  for (const double t : options.times)
    addLoops(result.fields, negativeOutlines(blendedField(first, second, t), grid, progress));
  result.fields.milliseconds = watch.elapsedMs();
}

void byVertices(MorphComparison& result, const Centred& a, const Centred& b, const ComparisonOptions& options,
                const Progress& progress) {
  result.whyNoVertices = whyUnmatched(a.polygons, b.polygons);
  if (!result.whyNoVertices.empty()) return;
  const Stopwatch watch;
  const MatchedOutlines matched = matchedOutlines(a.polygons, b.polygons, progress);
  std::vector<std::vector<Loop>> all;
  for (const double t : options.times) addLoops(result.vertices, all.emplace_back(inBetween(matched, t)));
  result.vertices.milliseconds = watch.elapsedMs();
  for (const std::vector<Loop>& loops : all) result.crossings.push_back(crossingsOf(loops, progress));
}

}  // namespace

MorphComparison compareMorphs(const Region& first, const Region& second, const ComparisonOptions& options,
                              const Progress& progress) {
  checkComparison(options);
  const Centred a = centred(first, options, "shape 1", progress), b = centred(second, options, "shape 2", progress);
  MorphComparison result;
  result.room = boxOf(a.polygons).merged(boxOf(b.polygons));
  constexpr double sumsEnd = 0.6, fieldsEnd = 0.9;
  bySums(result, a, b, options, progress.part(0, sumsEnd));
  byFields(result, a, b, options, progress.part(sumsEnd, fieldsEnd));
  byVertices(result, a, b, options, progress.part(fieldsEnd, 1));
  return result;
}

}  // namespace blossom::minkowski
