#include "kernel/morph/blended_area.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/planar/planar.h"
#include "kernel/morph/control_centre.h"
#include "kernel/morph/point_shape.h"

namespace blossom::minkowski {

namespace {

double lengthOf(const Region& region) {
  double sum = 0;
  for (const Path& loop : region.loops) sum += length(loop);
  return sum;
}

/// The largest distance of a corner from a point.
double reachFrom(const Vec2& point, const Region& region) {
  double reach = 0;
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) reach = std::max(reach, (startPoint(segment) - point).norm());
  return reach;
}

}  // namespace

BlendedArea::BlendedArea(std::span<const SoundRegion> shapes) {
  for (const SoundRegion& shape : shapes) {
    areas_.push_back(area(shape.region));
    centres_.push_back(isOrigin(shape) ? Vec2(Vec2::Zero()) : centroid(shape.region, shape.tolerance));
  }
}

double BlendedArea::blended(std::span<const double> shares) const {
  return std::inner_product(shares.begin(), shares.end(), areas_.begin(), 0.0);
}

InBetween BlendedArea::of(const InBetween& given, std::span<const double> shares) const {
  if (isOrigin(given.shape)) return given;
  Vec2 centre = Vec2::Zero();
  for (std::size_t i = 0; i < shares.size(); ++i) centre += shares[i] * centres_[i];
  const double wanted = blended(shares);
  const double area = blossom::area(given.shape.region), factor = std::sqrt(wanted / area);
  InBetween made{translated(scaled(translated(given.shape, -centre), factor), centre)};
  // The area is right within what lies along the boundary, and so is the factor.
  const double least = area - given.deviation * lengthOf(made.shape.region) / factor;
  const double more = least > 0 ? std::sqrt(wanted / least) - factor : factor;
  made.deviation = given.deviation * factor + more / factor * reachFrom(centre, made.shape.region);
  return made;
}

}  // namespace blossom::minkowski
