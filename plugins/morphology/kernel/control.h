#pragma once
#include <vector>

namespace blossom::morphology {

/// The control function f of a morph, [0,1] -> [0,1] (Definition 9).
enum class Control { Linear, Ease, EaseIn, EaseOut, Curve };

struct ControlPoint {
  double t = 0, value = 0;
};

/// f(t). Ease starts and ends at rest (3t^2 - 2t^3), ease-in starts and ease-out ends at rest. A curve is linear between its
/// points, whose t must not decrease, and constant before the first and after the last.
/// @throws Error InvalidParameter when a curve has no points.
double controlValue(Control, const std::vector<ControlPoint>& curve, double t);

}  // namespace blossom::morphology
