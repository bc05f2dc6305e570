#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/effort.h"

namespace blossom::minkowski {

struct RegionSumOptions {
  /// mm, between the exact result and its polygons, divided among the shapes; empty: see FlatteningOptions
  std::optional<double> tolerance{};
  std::size_t maximumWork = Effort::unlimited;  ///< see effort.h
};

struct RegionSumResult {
  Region region;  ///< outer loops counter-clockwise, holes clockwise
  std::size_t sums = 0;
  std::vector<std::string> warnings;
};

/// A + B + .. (Lee, Lee, Kim & Kim 2002, section 1): all sums of a point of each, about the origin of the document. Lines
/// and arcs stay lines and arcs, splines become cubic splines within the tolerance.
/// @throws Error InvalidParameter (fewer than two), InvalidInput naming shape and place (see flattening.h), LimitExceeded,
/// Cancelled; TooMuchWork. O((m + k) log m) for the m edges of the convolution with k crossings.
RegionSumResult minkowskiSum(std::span<const Region>, const RegionSumOptions& = {}, const Progress& = Progress::none());

/// A - B - ..: the points p with p + B inside A (erosion), regularised. A is approximated from inside and the others from
/// outside, so that the result is never too large; where it is hardly wider than the tolerance, a warning says so. @throws
/// as minkowskiSum; Degenerate when nothing is left.
RegionSumResult minkowskiDifference(std::span<const Region>, const RegionSumOptions& = {},
                                    const Progress& = Progress::none());

/// A - B - .. as minkowskiDifference; empty when nothing is left.
Region roomInside(std::span<const Region>, const RegionSumOptions&, const Progress&);

/// (A - B) + B: the part of A that B covers while it stays inside. @throws as minkowskiDifference
RegionSumResult regionOpening(const Region& a, const Region& b, const RegionSumOptions& = {},
                              const Progress& = Progress::none());

/// (A + B) - B: A with the places filled that -B cannot reach from outside. @throws as minkowskiSum
RegionSumResult regionClosing(const Region& a, const Region& b, const RegionSumOptions& = {},
                              const Progress& = Progress::none());

}  // namespace blossom::minkowski
