#include "geometry/planar/winding/nested_paths.h"

#include <utility>

#include "geometry/planar/planar.h"
#include "geometry/planar/winding/nesting.h"

namespace blossom::planar {

namespace {

Nesting nestingOf(const std::vector<Path>& paths, double tolerance, const Progress& progress) {
  std::vector<Loop> loops;
  loops.reserve(paths.size());
  for (const Path& path : paths) loops.push_back(flatten(path, tolerance));
  return Nesting(std::move(loops), progress);
}

std::optional<Region> sortedPaths(const std::vector<Path>& paths, const std::optional<std::vector<Nesting::Part>>& parts) {
  if (!parts) return std::nullopt;
  Region region;
  for (const auto& [outer, holes] : *parts) {
    region.loops.push_back(paths[outer]);
    for (const std::size_t hole : holes) region.loops.push_back(paths[hole]);
  }
  return region;
}

}  // namespace

std::optional<Region> nestedPaths(const std::vector<Path>& paths, double tolerance, const Progress& progress) {
  return sortedPaths(paths, nestingOf(paths, tolerance, progress).parts());
}

std::optional<Region> nestedTouchingPaths(const std::vector<Path>& paths, double tolerance, const Progress& progress) {
  return sortedPaths(paths, nestingOf(paths, tolerance, progress).touchingParts(progress));
}

}  // namespace blossom::planar
