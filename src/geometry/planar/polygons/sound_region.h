#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.h"
#include "geometry/numeric/boxes.h"
#include "geometry/planar/polygons/polygons.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// An operand and result of sums: outer loops counter-clockwise each followed by its holes, no loop touching
/// another. Made by soundRegion of flattening.h.
struct SoundRegion {
  Region region;
  double tolerance = 0;  ///< mm between a curve and the polygons by which sums are decided
  bool plain = true;     ///< lines and arcs are all that was drawn
  // What is computed for a shape that takes part in many sums is kept, see Adder::keep of repetition.h.
  std::uint32_t kept = 0;  ///< number of the shape of which this is a multiple; 0: of none
  double factor = 1;       ///< above 0, of that shape
};

/// Whether not all segments are lines.
bool hasCurves(const Region&);
bool hasSplines(const Region&);
/// s A, about the origin of the document. A negative s also turns by 180 degrees; s = 0 is not allowed.
SoundRegion scaled(const SoundRegion&, double s);
SoundRegion translated(const SoundRegion&, const Vec2& by);
/// Whether there is one part, without holes, without a concave arc and without a right turn beyond rounding (1e-9 radians).
bool isConvex(const SoundRegion&);

/// Around segments: the circles of arcs and the poles of splines lie in it.
Box2 looseBox(std::span<const Path>);

/// The polygons of a region of lines. @pre no curves
Polygons toPolygons(const SoundRegion&);
/// A region of straight lines, outer loops each followed by its holes. Empty polygons make a region without loops.
Region toRegion(const Polygons&);

}  // namespace blossom::planar
