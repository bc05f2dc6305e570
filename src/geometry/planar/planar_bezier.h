#pragma once
#include <utility>
#include <vector>

#include "geometry/planar/region.h"

/// Rational Bézier pieces of planar splines, for flattening, integration and winding numbers.
namespace blossom {

/// Homogeneous poles (w x, w y, w) of one piece over [0, 1].
using BezierPiece = std::vector<Vec3>;

std::vector<BezierPiece> bezierPieces(const Spline2&);

struct PointAndTangent {
  Vec2 point, derivative;
};
/// de Casteljau's algorithm and the quotient rule.
PointAndTangent evaluate(const BezierPiece&, double t);
/// The halves before and after t = 1/2.
std::pair<BezierPiece, BezierPiece> halves(const BezierPiece&);

inline Vec2 euclidean(const Vec3& pole) { return pole.head<2>() / pole.z(); }

}  // namespace blossom
