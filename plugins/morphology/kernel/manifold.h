#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// The same faces with vertices doubled where only corners or edges touch, so that the surface is a manifold wherever that
/// needs no new vertices. At an edge with more than two faces, the two at each wedge of the inside belong together.
/// Vertices that no face uses are dropped. Faces must be oriented and run through every edge as often both ways. O(n log n).
Mesh manifoldOf(const Mesh&, const Progress& = Progress::none());

/// The same for triangles, with new vertices where it needs them: an edge of which both ends hang together otherwise gets
/// one in its middle, for each of its wedges.
Mesh manifoldOfTriangles(const Mesh& triangles, const Progress& = Progress::none());

}  // namespace blossom::morphology
