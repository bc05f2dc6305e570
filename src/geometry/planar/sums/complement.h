#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/numeric/boxes.h"
#include "geometry/planar/polygons/polygons.h"
#include "geometry/planar/polygons/sound_region.h"
#include "geometry/planar/polygons/sound_set.h"

namespace blossom::planar {

/// Around a set, with the points of its curves within the tolerance.
Box2 extentOf(const SoundRegion&);
Box2 extentOf(const SoundSet&);

/// The complement of a set within a frame that a shape of a size, wherever it meets the set, does not reach.
Polygons complement(const Polygons&, const Vec2& size, const Progress&);
/// Nothing where loops touch, as those of an earlier result may.
std::optional<SoundRegion> complement(const SoundRegion&, const Vec2& size, const Progress&);

}  // namespace blossom::planar
