#pragma once
#include <array>
#include <vector>

#include "core/vector.h"
#include "geometry/planar/planar_bezier.h"

namespace blossom {

/// Whether all weights are equal.
bool isPolynomial(const BezierPiece&);

/// The piece as consecutive polynomial cubics: exactly when its degree is at most 3 and it is polynomial; else it is halved
/// until cubics with its tangents at both ends are within the tolerance, compared at equal parameters.
std::vector<std::array<Vec2, 4>> cubicsOf(const BezierPiece&, double tolerance);

}  // namespace blossom
