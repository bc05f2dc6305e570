#pragma once
#include <vector>

#include "core/vector.h"
#include "geometry/planar/polygons/sound_region.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// An area, curves and points, of which any may be missing. Of nothing at all: the empty set.
struct PlanarSet {
  Region area;
  std::vector<Path> curves{};  ///< open
  std::vector<Vec2> points{};

  [[nodiscard]] bool empty() const { return area.loops.empty() && curves.empty() && points.empty(); }
  [[nodiscard]] bool isArea() const { return !area.loops.empty() && curves.empty() && points.empty(); }
};

/// The same as an operand and result of sums. Made by soundSet of flattening.h.
struct SoundSet {
  SoundRegion area;            ///< without loops: none
  std::vector<Path> curves{};  ///< open, each at least one segment long, segments of a length above 0
  std::vector<Vec2> points{};
  double tolerance = 0;  ///< mm between a curve and the polygons by which sums are decided; of the area, too

  [[nodiscard]] bool empty() const { return area.region.loops.empty() && curves.empty() && points.empty(); }
  [[nodiscard]] bool isArea() const { return !area.region.loops.empty() && curves.empty() && points.empty(); }
  [[nodiscard]] bool isPoints() const { return area.region.loops.empty() && curves.empty() && !points.empty(); }
};

/// Whether there is anything but lines and points.
bool isCurved(const SoundSet&);
bool isFreeForm(const SoundSet&);
/// s A, about the origin of the document, as of regions.
SoundSet scaled(const SoundSet&, double s);
SoundSet translated(const SoundSet&, const Vec2& by);

}  // namespace blossom::planar
