#pragma once
#include <array>
#include <vector>

#include "core/vector.h"
#include "geometry/planar/planar.h"

namespace blossom {

/// A piece of a planar spline in Bézier form, its poles homogeneous: (wx, wy, w).
using BezierPiece = std::vector<Vec3>;

/// The pieces of a spline between its knots, in order.
std::vector<BezierPiece> bezierPieces(const Spline2&);

inline Vec2 toPlane(const Vec3& pole) { return pole.head<2>() / pole.z(); }

/// All poles weigh the same.
bool isPolynomial(const BezierPiece&);

/// The piece as polynomial cubics, end to end: exactly where it is one of degree at most 3, else halved until cubics with
/// its tangents at both ends are no farther from it than the tolerance, compared at equal parameters.
std::vector<std::array<Vec2, 4>> cubicsOf(const BezierPiece&, double tolerance);

}  // namespace blossom
