#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// The same faces with vertices duplicated where only corners or edges touch, so that the surface is a manifold as far as
/// that is possible without new vertices. At an edge with more than two faces, the two faces at each interior wedge are
/// connected. Unused vertices are removed. Faces must be oriented and traverse every edge equally often in both directions.
/// O(n log n).
Mesh manifoldOf(const Mesh&, const Progress& = Progress::none());

/// The same for triangles, with new vertices where needed: an edge whose ends are connected by other faces is divided in the
/// middle, once for each of its wedges.
Mesh manifoldOfTriangles(const Mesh& triangles, const Progress& = Progress::none());

/// An edge around which inside and outside do not take turns: sheets that have it in common pass through each other there,
/// which no two faces tell.
struct TwistedEdge {
  Vec3 place = Vec3::Zero();
  std::vector<std::size_t> faces;  ///< around it
};
/// The first one among the edges of more than two faces; corners are one where they lie at one place. O(n log n).
std::optional<TwistedEdge> firstTwistedEdge(const Mesh&, const Progress& = Progress::none());

}  // namespace blossom::morphology
