#pragma once
#include <QString>

#include "core/units.h"
#include "geometry/shape/motion.h"
#include "geometry/shape/motion_edit.h"

namespace blossom::sweep {

/// "u 0.875  v 0.500": a place on the surface, in thousandths of the ranges of u and v.
QString placeNumbers(const Motion&, const MotionPlace&);

/// "r 62.0 mm, Δ 52.0": how far a point is from the trajectory, and how far it was taken; with as many decimals as the mouse
/// can tell apart. @param distance, way, millimetresPerPixel mm
QString dragNumbers(double distance, double way, const LengthUnit&, double millimetresPerPixel);

}  // namespace blossom::sweep
