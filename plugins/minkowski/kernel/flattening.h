#pragma once
#include <optional>
#include <string>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/effort.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// Where a polygon may lie that stands for a shape.
enum class Side {
  Either,   ///< within the tolerance
  Inside,   ///< and nowhere outside of the shape: what is cut from is not overstated
  Outside,  ///< and nowhere inside of its boundary: what is to fit somewhere is not understated
};

struct FlatteningOptions {
  /// mm between curves and their polygons; nothing: a 10,000th of the shape's size, but at most 0.01 mm
  std::optional<double> tolerance{};
  double share = 1;  ///< of the tolerance, where several shapes take one together
  Side side = Side::Either;
  Effort* effort = nullptr;  ///< what loops that touch may cost; nothing: as much as they take
};

/// Polygons within the tolerance of a region. Parts that touch along edges are joined.
/// @param name what the region is called in messages, "control shape 2"
/// @throws Error InvalidInput when it is empty, open, not finite, crosses itself or has a hole outside; InvalidParameter
/// when a tolerance is given that is more than a twentieth of a curved shape's size; LimitExceeded when it reaches farther
/// than 1e9 mm or needs more than 200,000 corners: each names the place. Cancelled; TooMuchWork. O(n log n) for well-spread
/// edges.
Polygons flattened(const Region&, const FlatteningOptions&, const std::string& name, const Progress& = Progress::none());

/// Straight lines along the loops, outer loops first and then their holes. An empty set gives a region without loops.
Region toRegion(const Polygons&);

}  // namespace blossom::minkowski
