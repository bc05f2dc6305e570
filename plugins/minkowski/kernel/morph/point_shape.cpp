#include "kernel/morph/point_shape.h"

#include <algorithm>
#include <utility>

#include "geometry/planar/polygons/refusal.h"
#include "geometry/planar/segment_box.h"
#include "geometry/planar/single_point.h"

namespace blossom::minkowski {

Region pointRegion(const Vec2& at) { return {{Path{{Line2{at, at}}, true, {}, {}}}}; }

std::optional<Vec2> pointIn(const Region& region) { return singlePoint(region.loops); }

bool repeatsAsMultiple(const SoundRegion& shape) { return isOrigin(shape) || isConvex(shape); }

SoundRegion soundControl(const Region& region, const FlatteningOptions& options, const std::string& name,
                         const Progress& progress) {
  const auto point = pointIn(region);
  if (!point) return soundRegion(region, options, name, progress);
  refuseWhatIsNoNumber(region.loops.front(), "the point", name);
  refuseFarAway(*point, name);
  return {};
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
  // Corners of what is smaller have no places apart.
  constexpr double share = 0x1p-40;
  if (made.loops.empty() || boxAround(made.loops).sizes().maxCoeff() < share * std::max(1.0, by.cwiseAbs().maxCoeff()))
    return pointRegion(by);
  return translated(SoundRegion{std::move(made)}, by).region;
}

}  // namespace blossom::minkowski
