#pragma once
#include <optional>
#include <string>

#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/polygons/polygons.h"
#include "geometry/planar/polygons/sound_region.h"
#include "geometry/planar/polygons/sound_set.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// Position of a polygon relative to the shape it approximates.
enum class Approximation {
  Either,   ///< within the tolerance on either side
  Inside,   ///< inside the shape, so that an area to fit into is never overestimated
  Outside,  ///< around the shape, so that a shape to be fitted is never underestimated
};

struct FlatteningOptions {
  /// mm between curves and their polygons; empty: see defaultTolerance
  std::optional<double> tolerance{};
  double share = 1;  ///< share of the tolerance, when several shapes divide it
  Approximation side = Approximation::Either;
  Effort* effort = nullptr;  ///< limit on the work for loops that touch; nullptr: unlimited
};

/// 1/10,000 of a shape's size and 1/500 of its thickness, at most 0.01 mm. @pre the region is not empty
double defaultTolerance(const Region&);
/// Twice the area over the perimeter: the width of a long strip, the radius of a disc. 0 of an empty region.
double thicknessOf(const Region&);

/// Polygons within the tolerance of a region. Parts that touch along edges are joined.
/// @param name of the region in messages, "control shape 2"
/// @throws Error, always with the place, InvalidInput when the region is empty, open, not finite, crosses itself or has a
/// hole outside; InvalidParameter when the tolerance exceeds 1/20 of a curved shape's size or 1/10 of its thickness;
/// LimitExceeded beyond 1e9 mm or 200,000 corners. Cancelled; TooMuchWork. O(n log n) for well-distributed edges.
Polygons flattened(const Region&, const FlatteningOptions&, const std::string& name, const Progress& = Progress::none());

/// Of a region that was checked before, within its tolerance or the default one, if that is smaller. @throws as flattened
Polygons polygonsBeside(const SoundRegion&, Approximation, const std::string& name, const Progress&, Effort&);

/// The same checks, but curves stay. Where loops touch each other or themselves, curves become lines. @throws as flattened
SoundRegion soundRegion(const Region&, const FlatteningOptions&, const std::string& name,
                        const Progress& = Progress::none());

/// The same of an area with curves and points, for the curves what does not need an area. Curves that are shorter than
/// 1e-7 mm are points. The empty set stays empty. @throws as flattened; InvalidInput where a curve has a gap
SoundSet soundSet(const PlanarSet&, const FlatteningOptions&, const std::string& name, const Progress& = Progress::none());

}  // namespace blossom::planar
