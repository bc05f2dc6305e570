#include "kernel/control.h"

#include <algorithm>

#include "core/error.h"

namespace blossom::morphology {

namespace {

double onCurve(const std::vector<ControlPoint>& curve, double t) {
  if (curve.empty())
    throw Error(ErrorCode::InvalidParameter, "The control curve has no points.", "Write for example 0:0, 0.5:0.9, 1:1.");
  if (t <= curve.front().t) return curve.front().value;
  const auto after = std::find_if(curve.begin(), curve.end(), [&](const ControlPoint& p) { return p.t >= t; });
  if (after == curve.end()) return curve.back().value;
  const ControlPoint &b = *after, &a = *(after - 1);
  const double share = b.t > a.t ? (t - a.t) / (b.t - a.t) : 1;
  return std::clamp((1 - share) * a.value + share * b.value, 0.0, 1.0);
}

}  // namespace

double controlValue(Control control, const std::vector<ControlPoint>& curve, double t) {
  switch (control) {
    case Control::Linear:
      return t;
    case Control::Ease:
      return t * t * (3 - 2 * t);
    case Control::EaseIn:
      return t * t;
    case Control::EaseOut:
      return t * (2 - t);
    case Control::Curve:
      return onCurve(curve, t);
  }
  return t;
}

}  // namespace blossom::morphology
