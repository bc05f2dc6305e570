#pragma once
#include <cstddef>
#include <vector>

#include "kernel/morph/shape_spline.h"

namespace blossom::minkowski {

/// How much each control shape counts over the time of a morph.
struct InfluenceCurves {
  std::vector<double> times;                ///< rising from 0 to 1
  std::vector<std::vector<double>> shares;  ///< of each shape, one for each time; at every time they add up to 1
};

/// Values of the basis functions (see influences of shape_spline.h) at evenly spaced times and at the knots, where they may
/// have corners. @pre the knots are checked; intervals is above 0. O(times x (shapes + degree^2))
InfluenceCurves influenceCurves(const ShapeKnots&, std::size_t intervals);

}  // namespace blossom::minkowski
