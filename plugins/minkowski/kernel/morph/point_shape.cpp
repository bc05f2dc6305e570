#include "kernel/morph/point_shape.h"

#include <utility>

#include "geometry/planar/single_point.h"

namespace blossom::minkowski {

Region pointRegion(const Vec2& at) { return {{Path{{Line2{at, at}}, true, {}, {}}}}; }

std::optional<Vec2> pointIn(const Region& region) { return singlePoint(region.loops); }

bool repeatsAsMultiple(const SoundRegion& shape) { return isOrigin(shape) || isConvex(shape); }

SoundRegion soundControl(const Region& region, const FlatteningOptions& options, const std::string& name,
                         const Progress& progress) {
  return pointIn(region) ? SoundRegion() : soundRegion(region, options, name, progress);
}

PointPlaces::PointPlaces(std::span<const Region> shapes) {
  for (const Region& shape : shapes) {
    const auto point = pointIn(shape);
    places_.push_back(point.value_or(Vec2::Zero()));
    any_ = any_ || point;
  }
}

Region PointPlaces::moved(Region made, std::span<const double> shares) const {
  if (!any_) return made;
  Vec2 by = Vec2::Zero();
  for (std::size_t i = 0; i < shares.size(); ++i) by += shares[i] * places_[i];
  if (made.loops.empty()) return pointRegion(by);
  return translated(SoundRegion{std::move(made)}, by).region;
}

}  // namespace blossom::minkowski
