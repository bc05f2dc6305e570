#pragma once
#include <span>

#include "core/vector.h"
#include "geometry/bspline/curve.h"

namespace blossom::subdivision {

/// The polyline through points as a curve of degree 1. @pre at least two points, neighbours differ.
Curve polylineThrough(std::span<const Vec3> points);

/// Natural cubic spline through points with chord-length parameters (de Boor, A Practical Guide to Splines, ch. IV), C2.
/// O(n). @pre as above.
Curve splineThrough(std::span<const Vec3> points);

}  // namespace blossom::subdivision
