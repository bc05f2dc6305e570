#pragma once
#include <optional>
#include <span>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/effort.h"

namespace blossom::minkowski {

struct RegionSumOptions {
  /// mm, between the result's curves and their polygons, shared among the shapes; nothing: see FlatteningOptions
  std::optional<double> tolerance{};
  std::size_t mostWork = Effort::unlimited;  ///< edges and crossings of arrangements
};

struct RegionSumResult {
  Region region;  ///< straight lines; outer loops counter-clockwise, holes clockwise
  std::size_t sums = 0;
};

/// A + B + .. (Lee, Lee, Kim & Kim 2002, section 1): every point of one plus every point of the other, about the origin of
/// the document. @throws Error InvalidParameter (fewer than two), InvalidInput naming shape and place (see flattening.h),
/// LimitExceeded, Cancelled; TooMuchWork. O((m + k) log m) for the m edges of the convolution, with k crossings.
RegionSumResult minkowskiSum(std::span<const Region>, const RegionSumOptions& = {}, const Progress& = Progress::none());

/// A - B - ..: the points p with p + B inside A (erosion), regularised. A is drawn from inside and what is taken away from
/// outside, so that no room is told where there is none. @throws as minkowskiSum; Degenerate when nothing is left.
RegionSumResult minkowskiDifference(std::span<const Region>, const RegionSumOptions& = {},
                                    const Progress& = Progress::none());

}  // namespace blossom::minkowski
