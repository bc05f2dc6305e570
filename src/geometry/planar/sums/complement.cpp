#include "geometry/planar/sums/complement.h"

#include <utility>

#include "geometry/planar/planar.h"
#include "geometry/planar/winding/nested_paths.h"
#include "geometry/planar/winding/nesting.h"

namespace blossom::planar {
namespace {

struct Frame {
  Vec2 low, high;
};

Frame frameAround(const Box2& box, const Vec2& size) {
  const Vec2 reach = 2 * size + box.sizes();
  return {box.min() - reach, box.max() + reach};
}

Loop theOtherWay(const Loop& loop) { return {loop.rbegin(), loop.rend()}; }

Path framePath(const Frame& frame) {
  const Vec2 &low = frame.low, &high = frame.high;
  const Vec2 right(high.x(), low.y()), left(low.x(), high.y());
  return {{Line2{low, right}, Line2{right, high}, Line2{high, left}, Line2{left, low}}, true, {}, {}};
}

void extendAlong(Box2& box, const Path& path, double tolerance) {
  for (const Vec2& p : flatten(path, tolerance)) box.extend(p);
}

}  // namespace

Box2 extentOf(const SoundRegion& shape) {
  Box2 box;
  for (const Path& loop : shape.region.loops) extendAlong(box, loop, shape.tolerance);
  return box;
}

Box2 extentOf(const SoundSet& set) {
  Box2 box = extentOf(set.area);
  for (const Path& curve : set.curves) extendAlong(box, curve, set.tolerance);
  for (const Vec2& point : set.points) box.extend(point);
  return box;
}

Polygons complement(const Polygons& polygons, const Vec2& size, const Progress& progress) {
  const auto [low, high] = frameAround(boxOf(polygons), size);
  std::vector<Loop> loops{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}};
  for (const Polygon& polygon : polygons) {
    loops.push_back(theOtherWay(polygon.outer));
    for (const Loop& hole : polygon.holes) loops.push_back(theOtherWay(hole));
  }
  return Nesting(std::move(loops), progress).polygons(progress);
}

std::optional<SoundRegion> complement(const SoundRegion& shape, const Vec2& size, const Progress& progress) {
  std::vector<Path> paths{framePath(frameAround(extentOf(shape), size))};
  for (const Path& loop : shape.region.loops) paths.push_back(reversed(loop));
  auto region = nestedTouchingPaths(paths, shape.tolerance, progress);
  if (!region) return std::nullopt;
  return SoundRegion{*std::move(region), shape.tolerance};
}

}  // namespace blossom::planar
