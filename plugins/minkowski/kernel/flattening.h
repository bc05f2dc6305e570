#pragma once
#include <optional>
#include <string>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/effort.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// Position of a polygon relative to the shape it approximates.
enum class Approximation {
  Either,   ///< within the tolerance on either side
  Inside,   ///< inside the shape, so that an area to fit into is never overestimated
  Outside,  ///< around the shape, so that a shape to be fitted is never underestimated
};

struct FlatteningOptions {
  /// mm between curves and their polygons; empty: 1/10,000 of the shape's size, at most 0.01 mm
  std::optional<double> tolerance{};
  double share = 1;  ///< share of the tolerance, when several shapes divide it
  Approximation side = Approximation::Either;
  Effort* effort = nullptr;  ///< limit on the work for loops that touch; nullptr: unlimited
};

/// Polygons within the tolerance of a region. Parts that touch along edges are joined.
/// @param name of the region in messages, "control shape 2"
/// @throws Error, always with the place, InvalidInput when the region is empty, open, not finite, crosses itself or has a
/// hole outside; InvalidParameter when the tolerance exceeds 1/20 of a curved shape's size; LimitExceeded beyond 1e9 mm or
/// 200,000 corners. Cancelled; TooMuchWork. O(n log n) for well-distributed edges.
Polygons flattened(const Region&, const FlatteningOptions&, const std::string& name, const Progress& = Progress::none());

/// A region of straight lines, outer loops each followed by its holes. Empty polygons make a region without loops.
Region toRegion(const Polygons&);

}  // namespace blossom::minkowski
