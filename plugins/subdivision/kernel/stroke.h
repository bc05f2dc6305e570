#pragma once
#include <span>

#include "core/vector.h"
#include "geometry/bspline/curve.h"

namespace blossom::subdivision {

/// The polygon through points as a curve of degree 1. @pre two points or more, neighbours differ.
Curve polyline(std::span<const Vec3> points);

/// Natural cubic spline through points with chord-length parameters (de Boor, A Practical Guide to Splines, ch. IV), twice
/// continuously differentiable. O(n). @pre as above.
Curve splineThrough(std::span<const Vec3> points);

}  // namespace blossom::subdivision
