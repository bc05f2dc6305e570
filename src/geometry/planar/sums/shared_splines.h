#pragma once
#include <optional>

#include "geometry/planar/region.h"

/// Free-form curves on each other, in whole or in part, whatever their degrees, knots and parametrisations.
namespace blossom::planar {

/// The share of the parameter range at which a point lies on a spline, if within `rounding`. O(poles).
std::optional<double> shareAt(const Spline2&, const Vec2&, double rounding);

/// The same curve between two shares of its parameter range, exactly but for rounding. @pre 0 <= from < to <= 1
Spline2 splinePart(const Spline2&, double from, double to);

/// Whether splines with the same start and end, within `rounding`, are one curve: points of the first are followed along the
/// second one. O(poles).
bool runTogether(const Spline2&, const Spline2&, double rounding);

}  // namespace blossom::planar
