#pragma once
#include <optional>
#include <vector>

#include "feature/feature_type.h"
#include "kernel/morph/shape_spline.h"

/// What the morph does with knots and sectors.
namespace blossom::minkowski {

/// @throws Error InvalidParameter for what a B-spline of shapes has no place for.
void refuseBesidesKnots(bool blossomOrPath, bool degreeElevate);
/// @param places when each region is seen
Shape sequenceOf(std::vector<Region>, std::vector<double> places);
/// A sequence of a frame for each of the times, or the in-between at the only one.
/// @param places when each frame is seen; empty: a single in-between
Evaluated morphedBySpline(const std::vector<Region>& shapes, const ShapeKnots&, const std::vector<double>& times,
                          const std::vector<double>& places, const MorphOptions&, const Progress&);

ParameterSpec sectorsSpec();

}  // namespace blossom::minkowski
