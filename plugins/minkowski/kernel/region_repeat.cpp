#include "kernel/region_repeat.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "geometry/planar/sums/convex_hull.h"
#include "geometry/planar/sums/flattening.h"
#include "kernel/hull_distance.h"
#include "kernel/morph/repetition.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

constexpr std::size_t largestCount = 1'000'000'000;

/// Lengths of a result as shares of those of [k]A.
double scaleOf(const RegionRepeatOptions& options) {
  return options.normalised ? 1 / static_cast<double>(options.count) : 1;
}

std::size_t segmentsOf(const SoundRegion& shape) {
  std::size_t count = 0;
  for (const Path& loop : shape.region.loops) count += loop.segments.size();
  return count;
}

/// Each copy adds about as many corners as the second one did.
void refuseEndlessCopies(const SoundRegion& shape, const SoundRegion& two, std::size_t count) {
  constexpr double largest = 200'000, quick = 20'000;  // corners: the second takes some ten seconds
  const auto first = static_cast<double>(segmentsOf(shape));
  const double growth = static_cast<double>(segmentsOf(two)) - first;
  if (!(growth > 0) || first + growth * static_cast<double>(count - 1) <= largest) return;
  throw Error(
      ErrorCode::LimitExceeded,
      fmt::format("{} copies of shape 1 would have about {:.1g} corners.", count,
                  first + growth * static_cast<double>(count - 1)),
      fmt::format("Give about {} copies, as the time grows with their square, or a larger tolerance. Normalised, the hull "
                  "stands for copies without end.",
                  static_cast<std::size_t>(std::max(0.0, quick - first) / growth) + 2));
}

RegionRepeatResult hullInstead(const SoundRegion& hull, RegionRepeatResult result, const RegionRepeatOptions& options,
                               double tolerance) {
  result.region = options.normalised ? hull.region : scaled(hull, static_cast<double>(options.count)).region;
  result.isHull = true;
  result.warnings.push_back(
      fmt::format("The hull stands for the {} copies: it is at most {:.3g} mm away, within the tolerance of {:.3g} mm.",
                  options.count, result.hullDistance, tolerance));
  return result;
}

}  // namespace

Region regionHull(const Region& region, const std::optional<double>& tolerance, const Progress& progress) {
  return convexHull(soundRegion(region, {.tolerance = tolerance}, "shape 1", progress), progress).region;
}

RegionRepeatResult regionRepeat(const Region& region, const RegionRepeatOptions& options, const Progress& progress) {
  if (options.count < 1 || options.count > largestCount)
    throw Error(ErrorCode::InvalidParameter, fmt::format("A shape cannot be added {} times.", options.count),
                fmt::format("Give a number of 1 to {}.", largestCount));
  Adder add(options.maximumWork);
  const SoundRegion shape =
      soundRegion(region, {.tolerance = options.tolerance, .effort = &add.effort()}, "shape 1", progress);
  const SoundRegion hull = convexHull(shape, progress);
  const double scale = scaleOf(options), tolerance = options.tolerance.value_or(defaultTolerance(region));
  constexpr double share = 1e-4;
  const double chord = share * circumradius(shape.region, tolerance, progress);
  RegionRepeatResult result;
  const bool convex = isConvex(shape);
  result.hullBound =
      convex ? 0 : std::numbers::sqrt2 * scale * circumradius(hull.region, std::min(chord, tolerance), progress);
  result.hullDistance = result.hullBound;
  if (options.count > 2 && !convex) {
    if (result.hullDistance > tolerance) {
      // Of every [k]A, k >= 2, from its hull.
      const SoundRegion two = repeated(shape, 2, add, progress);
      const double ofTwo = isConvex(two) ? 0 : distanceToHull(two.region, scaled(hull, 2).region, chord, progress).atMost;
      result.hullDistance = std::min(result.hullBound, scale * ofTwo);
      if (result.hullDistance > tolerance) refuseEndlessCopies(shape, two, options.count);
    }
    result.sums = add.count();
    if (result.hullDistance <= tolerance) return hullInstead(hull, std::move(result), options, tolerance);
  }
  Adder all(options.maximumWork);
  all.plan(sumsOfRepetition(convex, options.count));
  const SoundRegion repetition = scaled(repeated(shape, options.count, all, progress), scale);
  result.sums = all.count();
  const SoundRegion around = scaled(hull, scale * static_cast<double>(options.count));
  result.hullDistance =
      convex || isConvex(repetition)
          ? 0
          : distanceToHull(repetition.region, around.region, std::max(chord * scale, 1e-6 * chord / share), progress)
                .distance;
  result.isHull = result.hullDistance <= 0;
  result.region = repetition.region;
  return result;
}

}  // namespace blossom::minkowski
