#pragma once
#include <cmath>
#include <numbers>

#include "core/vector.h"
#include "geometry/planar/region.h"

/// Angles in radians.
namespace blossom::planar {

constexpr double fullTurn = 2 * std::numbers::pi;
constexpr double sameAngle = 1e-9;  ///< directions that differ by no more are one

inline Vec2 unitAt(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// From `of` to `angle` the shorter way, counter-clockwise positive.
inline double turnFrom(double of, double angle) { return std::remainder(angle - of, fullTurn); }

/// The same direction, 0 to 2 pi.
inline double inOneTurn(double angle) {
  const double inside = std::fmod(angle, fullTurn);
  return inside < 0 ? inside + fullTurn : inside;
}

/// From the start of an arc to the angle of a point, in the direction of the arc, 0 to 2 pi.
inline double turnAlong(const Arc2& arc, const Vec2& point) {
  const Vec2 out = point - arc.center;
  const double angle = std::atan2(out.y(), out.x());
  return inOneTurn(arc.sweep > 0 ? angle - arc.start : arc.start - angle);
}

/// Angle of the outward normal where an arc has the angle phi: away from its centre when it turns left, else towards it.
inline double normalAt(const Arc2& arc, double phi) { return arc.sweep > 0 ? phi : phi + std::numbers::pi; }

}  // namespace blossom::planar
