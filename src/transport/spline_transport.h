#pragma once
#include "geometry/shape/motion.h"
#include "parameter/value.h"

namespace blossom {

/// Spline curves, spline surfaces and motions as JSON.
Value curveValue(const Curve&);
Curve toCurve(const Value&);
Value surfaceValue(const Surface&);
Surface toSurface(const Value&);
Value motionValue(const Motion&);
Motion toMotion(const Value&);

}  // namespace blossom
