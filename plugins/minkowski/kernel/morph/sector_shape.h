#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/sound_region.h"

namespace blossom::minkowski {

using namespace planar;

/// A range of directions, counter-clockwise, radians. Equal ends, or a whole turn between them: all directions.
struct Sector {
  double from = 0, to = 0;
  friend bool operator==(const Sector&, const Sector&) = default;
};

/// The part of a shape that acts in the directions of a sector: the hull of its boundary points with normals there. It
/// reaches as far as the shape in these directions; elsewhere it has one straight chord (edges must close), so adding it
/// rounds the side that faces the sector and adds one straight edge on the other. Lines and arcs stay; where the hull has
/// free-form parts it is a polygon within the tolerance. O(n log n).
/// @throws Error InvalidParameter when a corner or a straight side is all that faces the sector.
SoundRegion facing(const SoundRegion&, const Sector&, const std::string& name, const Progress& = Progress::none());

/// Puts in place of the first shapes of a morph what of them faces their sectors; points stay, and shapes that act in all
/// directions, with their dents.
/// @throws Error InvalidParameter also when there are more sectors than shapes; as soundRegion of flattening.h
void faceSectors(std::vector<Region>& shapes, std::span<const Sector>, const std::optional<double>& tolerance,
                 const Progress& = Progress::none());

}  // namespace blossom::minkowski
