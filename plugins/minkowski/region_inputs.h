#pragma once
#include <optional>
#include <vector>

#include "feature/feature_type.h"
#include "feature/registry.h"
#include "geometry/planar/region.h"
#include "kernel/region_sum.h"

namespace blossom::minkowski {

/// The regions of the first input.
std::vector<Region> regionsOf(const Inputs&);

/// Of a parameter that may be null: the tolerance then follows the shapes' sizes.
std::optional<double> toleranceOf(const Value& given);
ParameterSpec toleranceSpec();

/// With the number of sums.
Evaluated evaluatedSum(RegionSumResult);

}  // namespace blossom::minkowski
