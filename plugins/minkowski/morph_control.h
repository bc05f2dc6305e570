#pragma once
#include <optional>
#include <vector>

#include "feature/feature_type.h"
#include "kernel/morph/shape_spline.h"

/// What the morph does with knots and sectors.
namespace blossom::minkowski {

/// @throws Error InvalidParameter for what a B-spline of shapes has no place for.
void refuseBesidesKnots(bool blossom, bool degreeElevate, bool areaPreserving);
/// A sequence of frames, or at 0 frames the in-between at t.
Evaluated morphedBySpline(const std::vector<Region>& shapes, const ShapeKnots&, int frames, double t, const MorphOptions&,
                          const Progress&);

ParameterSpec sectorsSpec();
/// Puts in place of shapes what of them faces their sectors.
void faceSectors(std::vector<Region>& shapes, const std::vector<Value>& sectors, const std::optional<double>& tolerance,
                 const Progress&);

}  // namespace blossom::minkowski
