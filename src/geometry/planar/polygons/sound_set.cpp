#include "geometry/planar/polygons/sound_set.h"

#include <cmath>

namespace blossom::planar {
namespace {

SoundRegion curvesAsRegion(const SoundSet& set) { return {{set.curves}, set.tolerance}; }

}  // namespace

bool isCurved(const SoundSet& set) { return hasCurves(set.area.region) || hasCurves(Region{set.curves}); }

bool isFreeForm(const SoundSet& set) { return hasSplines(set.area.region) || hasSplines(Region{set.curves}); }

SoundSet scaled(const SoundSet& set, double s) {
  SoundSet image{scaled(set.area, s), scaled(curvesAsRegion(set), s).region.loops, set.points, std::abs(s) * set.tolerance};
  for (Vec2& point : image.points) point *= s;
  return image;
}

SoundSet translated(const SoundSet& set, const Vec2& by) {
  SoundSet image{translated(set.area, by), translated(curvesAsRegion(set), by).region.loops, set.points, set.tolerance};
  for (Vec2& point : image.points) point += by;
  return image;
}

}  // namespace blossom::planar
