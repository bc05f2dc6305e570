#include "kernel/morph/control_centre.h"

#include <cmath>
#include <vector>

#include "geometry/numeric/boxes.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/segment_box.h"

namespace blossom::minkowski {
namespace {

/// Area and first moment of loops about a point.
struct Moments {
  Vec2 about;
  double twice = 0;
  Vec2 moment = Vec2::Zero();

  void add(const std::vector<Vec2>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i] - about, b = loop[(i + 1) % loop.size()] - about;
      moment += blossom::cross(a, b) * (a + b);
      twice += blossom::cross(a, b);
    }
  }
  [[nodiscard]] Vec2 centre() const { return about + moment / (3 * twice); }
};

}  // namespace

Vec2 centroid(const Region& region, double chord) {
  Moments moments{startPoint(region.loops.front())};
  for (const Path& loop : region.loops) moments.add(flatten(loop, chord));
  return moments.centre();
}

Vec2 centreOf(const Region& region) {
  Box2 box;
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) box.extend(boxAround(segment));
  if (box.isEmpty()) return Vec2::Zero();
  Vec2 middle = box.center();
  const double size = box.sizes().norm();
  if (size == 0) return middle;
  if (!std::isfinite(size)) return Vec2::Zero();
  Moments moments{middle};
  for (const Path& loop : region.loops) moments.add(flatten(loop, size / 1000));
  return std::abs(moments.twice) > 1e-9 * size * size ? moments.centre() : middle;
}

}  // namespace blossom::minkowski
