#include "kernel/outline_sweep.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/sums/curved_union.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/winding/nested_paths.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

double toleranceFor(const Region& a, const Region& b, const RegionSumOptions& options) {
  return options.tolerance.value_or(std::min(defaultTolerance(a), defaultTolerance(b)));
}

/// Regions that are bounded by the loops; several where the loops lie in one another.
std::vector<Region> bounded(const Region& sound, Boundary boundary, double tolerance, const Progress& progress) {
  if (boundary == Boundary::All) return {sound};
  std::vector<Path> loops;
  for (const Path& loop : sound.loops) {
    const bool hole = signedArea(loop) < 0;
    if (hole == (boundary == Boundary::Holes)) loops.push_back(hole ? reversed(loop) : loop);
  }
  if (loops.empty())
    throw Error(ErrorCode::InvalidInput, "Shape 1 has no holes to follow.", "Follow its outer boundary, or all of it.");
  if (auto together = nestedPaths(loops, tolerance, progress)) return {*std::move(together)};
  std::vector<Region> each;
  each.reserve(loops.size());
  for (const Path& loop : loops) each.push_back({{loop}});
  return each;
}

/// Each with its holes.
std::vector<Region> partsOfSound(const Region& sound) {
  std::vector<Region> parts;
  for (const Path& loop : sound.loops) {
    if (signedArea(loop) > 0) parts.emplace_back();
    parts.back().loops.push_back(loop);
  }
  return parts;
}

Region turnedAround(const Region& region) {
  Eigen::Matrix<double, 2, 3> turn;
  turn << -Eigen::Matrix2d::Identity(), Vec2::Zero();
  Region image = region;
  for (Path& loop : image.loops) loop = transformed(loop, turn);
  return image;
}

/// Along all of the boundary of A. @pre B has one part
Region sweptAlongAll(const Region& a, const Region& b, const RegionSumOptions& options, double tolerance,
                     const Progress& progress) {
  Region sum = minkowskiSum(std::vector{a, b}, options, progress.part(0, 0.5)).region;
  const Region room = roomInside(std::vector{a, turnedAround(b)}, options, progress.part(0.5, 1));
  if (room.loops.empty()) return sum;
  std::vector<Path> loops = sum.loops;
  for (const Path& loop : room.loops) loops.push_back(reversed(loop));
  if (auto region = nestedTouchingPaths(loops, tolerance, progress)) return *std::move(region);
  throw Error(ErrorCode::Degenerate, "Loops of the room inside of shape 1 touch each other.",
              "Make shape 2 a little smaller or larger.");
}

}  // namespace

RegionSumResult outlineSweep(const Region& a, const Region& b, Boundary boundary, const RegionSumOptions& options,
                             const Progress& progress) {
  const FlatteningOptions same{.tolerance = options.tolerance};
  const Region soundA = soundRegion(a, same, "shape 1", progress).region,
               soundB = soundRegion(b, same, "shape 2", progress).region;
  const double tolerance = toleranceFor(soundA, soundB, options);
  const std::vector<Region> followed = bounded(soundA, boundary, tolerance, progress), parts = partsOfSound(soundB);
  RegionSumResult result;
  std::vector<SoundRegion> sweeps;
  const auto all = static_cast<double>(followed.size() * parts.size());
  for (const Region& each : followed)
    for (const Region& part : parts) {
      const auto done = static_cast<double>(sweeps.size());
      const Progress share = progress.part(done / (all + 1), (done + 1) / (all + 1));
      sweeps.push_back({sweptAlongAll(each, part, options, tolerance, share), tolerance});
      result.sums += 2;
    }
  Effort effort(options.maximumWork);
  result.region = united(sweeps, progress.part(all / (all + 1), 1), effort).region;
  return result;
}

}  // namespace blossom::minkowski
