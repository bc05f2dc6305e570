#pragma once
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

enum class BallFit {
  Inscribed,     ///< vertices on the sphere: the polyhedron lies in the ball
  Circumscribed  ///< faces touch or pass outside of the sphere: the ball lies in the polyhedron
};

struct BallOptions {
  double radius = 1;     ///< mm, above 0
  int subdivisions = 1;  ///< 0: the icosahedron; each one makes four triangles of one: 20, 80, 320, 1280, ..
  BallFit fit = BallFit::Inscribed;
};

struct BallResult {
  Mesh mesh;             ///< about the origin
  double deviation = 0;  ///< mm, largest distance between the polyhedron and the sphere
};

inline constexpr int mostSubdivisions = 6;

/// A geodesic ball. Its vertices have the same directions at every radius, so that growing it only moves points.
/// @throws Error InvalidParameter.
BallResult ball(const BallOptions&);

}  // namespace blossom::morphology
