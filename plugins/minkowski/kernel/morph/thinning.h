#pragma once
#include "core/progress.h"
#include "geometry/planar/polygons/sound_region.h"

namespace blossom::minkowski {

using namespace planar;

/// Fills the shallow dents of shapes that are to be added again and have very many corners (see shallow_dents.h). Sums,
/// multiples and blends of shapes are at most as far from those of the shapes as they were as these are.
class Thinning {
 public:
  /// @param depth of dents, mm
  explicit Thinning(double depth) : depth_(depth) {}

  /// The shape itself when it has curves or few corners.
  SoundRegion operator()(SoundRegion, const Progress&);
  /// The deepest dent that was filled, mm.
  [[nodiscard]] double deepest() const { return deepest_; }

 private:
  double depth_, deepest_ = 0;
};

}  // namespace blossom::minkowski
