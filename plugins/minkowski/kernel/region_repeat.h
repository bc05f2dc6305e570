#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/region.h"

namespace blossom::minkowski {

using namespace planar;

struct RegionRepeatOptions {
  std::size_t count = 2;                        ///< k, at least 1
  bool normalised = false;                      ///< (1/k) [k]A instead of [k]A
  std::optional<double> tolerance{};            ///< mm of the result; empty: see FlatteningOptions
  std::size_t maximumWork = Effort::unlimited;  ///< see effort.h
};

struct RegionRepeatResult {
  Region region;
  std::size_t sums = 0;
  /// Largest distance of a point of the hull from the result, mm: measured, or when the hull stands for the result, an
  /// upper bound.
  double hullDistance = 0;
  double hullBound = 0;  ///< the bound of the theorem of Shapley and Folkman: sqrt(2) R / k, R the radius around A
  bool isHull = false;   ///< the result is the hull, which is within the tolerance
  std::vector<std::string> warnings;
};

/// The hull of a region, which is checked first. @throws Error as soundRegion of flattening.h
Region regionHull(const Region&, const std::optional<double>& tolerance, const Progress& = Progress::none());

/// [k]A, the sum of k copies of A, or (1/k) [k]A, which lies between A and its hull and comes nearer to the hull with k
/// (Lee, Lee, Kim & Kim 2002, section 2.3, equation 1.3). By doubling. No hull of a [k]A is farther from it than that of
/// [2]A is from [2]A: of k + 1 > 2 summands in the hull of A with one sum, all but two may be chosen in A (Shapley and
/// Folkman), so one is, and the others are no farther from [k]A than before. Once this distance, or sqrt(2) R, is within the
/// tolerance the hull is taken. @throws Error InvalidParameter; those of minkowskiSum.
RegionRepeatResult regionRepeat(const Region&, const RegionRepeatOptions&, const Progress& = Progress::none());

}  // namespace blossom::minkowski
