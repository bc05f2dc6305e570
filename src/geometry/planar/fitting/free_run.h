#pragma once
#include <span>

#include "geometry/planar/fitting/true_curve.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// Consecutive sides of a polygon that stand for one free-form curve, and the corners that they pass: one more than sides.
/// Sides of two curves have ends beside the curve, and hollow ones cross each other before they end.
struct FreeRun {
  std::span<const Vec2> corners;
  std::span<const FreeSide> sides;
};

/// A spline from a place to another one through the points of the curve that the sides know. Where these are far apart, it
/// passes as many corners between them as keep it beside all of them. O(n log n) for n sides.
/// @param rounding within which points are one  @param gap between the polygon and the curve, at most
Spline2 splineAlong(const FreeRun&, const Vec2& from, const Vec2& to, double rounding, double gap);

}  // namespace blossom::planar
