#pragma once
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

enum class BallFit {
  Inscribed,     ///< vertices on the sphere: the polyhedron is inside the ball
  Circumscribed  ///< faces touch or lie outside the sphere: the ball is inside the polyhedron
};

struct BallOptions {
  double radius = 1;     ///< mm, above 0
  int subdivisions = 1;  ///< 0: the icosahedron; each divides a triangle into four: 20, 80, 320, 1280, ..
  BallFit fit = BallFit::Inscribed;
};

struct BallResult {
  Mesh mesh;             ///< about the origin
  double deviation = 0;  ///< mm, largest distance between the polyhedron and the sphere
};

inline constexpr int maximumSubdivisions = 6;

/// A geodesic ball. The directions of its vertices do not depend on the radius, so growing it only moves points.
/// @throws Error InvalidParameter.
BallResult ball(const BallOptions&);

}  // namespace blossom::morphology
