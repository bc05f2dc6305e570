#pragma once
#include <array>
#include <vector>

#include "core/vector.h"
#include "geometry/planar/planar.h"

namespace blossom {

/// A Bézier piece of a planar spline with homogeneous poles (wx, wy, w).
using BezierPiece = std::vector<Vec3>;

/// The pieces of a spline between its knots, in order.
std::vector<BezierPiece> bezierPieces(const Spline2&);

inline Vec2 toPlane(const Vec3& pole) { return pole.head<2>() / pole.z(); }

/// Whether all weights are equal.
bool isPolynomial(const BezierPiece&);

/// The piece as consecutive polynomial cubics: exactly when its degree is at most 3 and it is polynomial; else it is halved
/// until cubics with its tangents at both ends are within the tolerance, compared at equal parameters.
std::vector<std::array<Vec2, 4>> cubicsOf(const BezierPiece&, double tolerance);

}  // namespace blossom
