#pragma once
#include <span>
#include <vector>

#include "geometry/planar/polygons/sound_region.h"
#include "kernel/morph/expansion.h"

namespace blossom::minkowski {

/// Gives in-betweens the area that blends those of the control shapes, as t blends the shapes (the fifth open question of
/// Lee, Lee, Kim & Kim 2002, section 6).
class BlendedArea {
 public:
  explicit BlendedArea(std::span<const SoundRegion> shapes);

  /// Of shares that add up to 1; beyond the ends it may not be above 0.
  [[nodiscard]] double blended(std::span<const double> shares) const;
  /// Scales about the blend of the centres. @pre the blended area is above 0
  [[nodiscard]] InBetween of(const InBetween&, std::span<const double> shares) const;

 private:
  std::vector<double> areas_;
  std::vector<Vec2> centres_;
};

}  // namespace blossom::minkowski
