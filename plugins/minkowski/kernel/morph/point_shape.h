#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/sound_region.h"
#include "geometry/planar/sums/flattening.h"

namespace blossom::minkowski {

using namespace planar;

/// A point as a control shape: a region whose only loop is one line without length.
Region pointRegion(const Vec2&);
/// The place of a point; nothing for other regions.
std::optional<Vec2> pointIn(const Region&);

/// In sums a point is the origin alone, {0}, which changes no shape: a sound region without loops.
inline bool isOrigin(const SoundRegion& shape) { return shape.region.loops.empty(); }
/// Whether [k]A = k A for every k.
bool repeatsAsMultiple(const SoundRegion&);

/// What takes part in sums for a control shape. @throws as soundRegion of flattening.h; points, too, are refused beyond 1e9
/// mm
SoundRegion soundControl(const Region&, const FlatteningOptions&, const std::string& name, const Progress&);

/// The places of those control shapes that are points. A + w {p} is A moved by w p, so what points contribute to an
/// in-between is one translation.
class PointPlaces {
 public:
  explicit PointPlaces(std::span<const Region> shapes);
  /// An in-between of the control shapes with their points at the origin, moved to where these are; the point itself where
  /// nothing else takes part, or the rest is smaller than 2^-40 mm or that share of its distance from the origin.
  /// @param shares of all control shapes
  [[nodiscard]] Region moved(Region, std::span<const double> shares) const;

 private:
  std::vector<Vec2> places_;  ///< (0, 0) of other shapes
  bool any_ = false;
};

}  // namespace blossom::minkowski
