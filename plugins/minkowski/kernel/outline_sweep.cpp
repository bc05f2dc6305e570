#include "kernel/outline_sweep.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "kernel/flattening.h"
#include "kernel/nested_paths.h"

namespace blossom::minkowski {
namespace {

double toleranceFor(const Region& a, const Region& b, const RegionSumOptions& options) {
  return options.tolerance.value_or(std::min(defaultTolerance(a), defaultTolerance(b)));
}

/// The sound region that the loops bound.
Region bounded(const Region& sound, Boundary boundary, double tolerance, const Progress& progress) {
  if (boundary == Boundary::All) return sound;
  std::vector<Path> loops;
  for (const Path& loop : sound.loops) {
    const bool hole = signedArea(loop) < 0;
    if (hole == (boundary == Boundary::Holes)) loops.push_back(hole ? reversed(loop) : loop);
  }
  if (loops.empty())
    throw Error(ErrorCode::InvalidInput, "Shape 1 has no holes to follow.", "Follow its outer boundary, or all of it.");
  const auto region = nestedPaths(loops, tolerance, progress);
  if (!region)
    throw Error(ErrorCode::InvalidInput, "Some of the loops of shape 1 that are to be followed lie in one another.",
                "Follow all of its boundary, or one part after the other.");
  return *region;
}

void refuseParts(const Region& sound) {
  const auto parts =
      std::count_if(sound.loops.begin(), sound.loops.end(), [](const Path& loop) { return signedArea(loop) > 0; });
  if (parts > 1)
    throw Error(ErrorCode::InvalidInput, "Shape 2, which is swept, has more than one part.",
                "Sweep one part after the other and unite the results.");
}

Region turnedAround(const Region& region) {
  Eigen::Matrix<double, 2, 3> turn;
  turn << -Eigen::Matrix2d::Identity(), Vec2::Zero();
  Region image = region;
  for (Path& loop : image.loops) loop = transformed(loop, turn);
  return image;
}

}  // namespace

RegionSumResult outlineSweep(const Region& a, const Region& b, Boundary boundary, const RegionSumOptions& options,
                             const Progress& progress) {
  const double tolerance = toleranceFor(a, b, options);
  const FlatteningOptions same{.tolerance = options.tolerance};
  const Region sound = soundRegion(a, same, "shape 1", progress).region;
  refuseParts(soundRegion(b, same, "shape 2", progress).region);
  const Region followed = bounded(sound, boundary, tolerance, progress);
  RegionSumResult result = minkowskiSum(std::vector{followed, b}, options, progress.part(0, 0.5));
  const Region room = roomInside(std::vector{followed, turnedAround(b)}, options, progress.part(0.5, 1));
  ++result.sums;
  if (room.loops.empty()) return result;
  std::vector<Path> loops = result.region.loops;
  for (const Path& loop : room.loops) loops.push_back(reversed(loop));
  if (auto region = nestedPaths(loops, tolerance, progress)) {
    result.region = *std::move(region);
    return result;
  }
  throw Error(ErrorCode::Degenerate, "Loops of the room inside of shape 1 touch each other.",
              "Make shape 2 a little smaller or larger.");
}

}  // namespace blossom::minkowski
