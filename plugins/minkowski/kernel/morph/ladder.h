#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/region.h"

namespace blossom::minkowski {

using namespace planar;

struct LadderOptions {
  std::optional<double> tolerance{};            ///< mm, between curves and their polygons; empty: see FlatteningOptions
  std::size_t maximumWork = Effort::unlimited;  ///< see effort.h
};

struct LadderResult {
  /// levels[r][i] is C_i^r: the control shapes themselves at r = 0, one shape at r = n. A level whose work was too much is
  /// missing, with all after it.
  std::vector<std::vector<Region>> levels;
  std::size_t sums = 0;  ///< Minkowski sums computed, n (n+1) / 2 of a whole ladder with no number 0 or 1
  bool complete = true;  ///< no level is missing
};

/// The intermediate shapes of de Casteljau's algorithm for control shapes A0..An and one number in 0..1 for each level:
/// C_i^r = (1-t_r) C_i^(r-1) + t_r C_(i+1)^(r-1) (Lee, Lee, Kim & Kim 2002, equations 4.5 and 4.10). The last shape is that
/// of `morph` with the same arguments. Level r has n-r+1 shapes.
/// @throws Error InvalidParameter (fewer than two shapes, a wrong number of numbers, numbers outside 0..1), InvalidInput
/// naming the shape and the place (see flattening.h), LimitExceeded, Cancelled.
LadderResult ladder(std::span<const Region> shapes, std::span<const double> t, const LadderOptions& = {},
                    const Progress& = Progress::none());

}  // namespace blossom::minkowski
