#pragma once
#include <algorithm>
#include <cmath>

#include "kernel/outline/outline_drawn.h"

/// Coordinates that were computed from typed sizes, without the dirt of rounding: 40.00000000000001 is meant to be 40.
namespace blossom::modeling {

/// The multiple of 1e-9 mm that a coordinate is but for rounding, else the coordinate itself.
/// @param size the largest coordinate of what it belongs to
inline double tidied(double value, double size) {
  // 1e9 is a double, 1e-9 is none: divided by the former, decimals come out as they are typed.
  constexpr double steps = 1e9, dirt = 1e-13;
  const double meant = std::round(value * steps) / steps;
  return std::abs(value - meant) <= dirt * size ? meant + 0.0 /* no -0 */ : value;
}

inline Vec2 tidied(const Vec2& p, double size) { return {tidied(p.x(), size), tidied(p.y(), size)}; }

inline double sizeOf(const Vec2& p) { return p.cwiseAbs().maxCoeff(); }

inline DrawnOutline tidied(DrawnOutline outline) {
  double size = sizeOf(outline.start);
  for (const DrawnSegment& segment : outline.segments) size = std::max(size, sizeOf(segment.to));
  outline.start = tidied(outline.start, size);
  for (DrawnSegment& segment : outline.segments) {
    segment.to = tidied(segment.to, size);
    for (Vec2& p : segment.through) p = tidied(p, size);
  }
  return outline;
}

}  // namespace blossom::modeling
