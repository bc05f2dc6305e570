#pragma once
#include <optional>
#include <vector>

#include "feature/feature_type.h"
#include "feature/registry.h"
#include "geometry/planar/region.h"
#include "geometry/planar/sums/region_sum.h"
#include "geometry/planar/sums/set_operations.h"

namespace blossom::minkowski {

using namespace planar;

/// The regions of the first input.
std::vector<Region> regionsOf(const Inputs&);

/// Kinds of shapes that are sets of the plane.
inline const std::vector<ShapeKind> setKinds = {ShapeKind::Region, ShapeKind::Curves, ShapeKind::Curve};

/// The shapes of the first input: the area that closed curves bound, open curves, and curves without length as points.
/// @throws Error InvalidInput for a drawing of nothing, for what is not flat or crosses itself
std::vector<PlanarSet> setsOf(const Inputs&);

/// Of a parameter that may be null: the tolerance then follows the shapes' sizes.
std::optional<double> toleranceOf(const Value& given);
ParameterSpec toleranceSpec();

/// With the number of sums.
Evaluated evaluatedSum(RegionSumResult);
/// A region where there are no curves and points, else a drawing of all.
Evaluated evaluatedSet(SetSumResult);

}  // namespace blossom::minkowski
