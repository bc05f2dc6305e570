#pragma once
#include <TopoDS_Shape.hxx>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::modeling {

/// The solids that a closed mesh bounds, with planar faces: polygons in one plane are one face, and their straight edges one
/// edge. Polygons that are not planar become triangles. About O(n log n), some milliseconds for each face.
/// @throws Error InvalidInput for a mesh that is open or crosses itself, with the place; LimitExceeded for more than 20,000
/// faces; Degenerate where OCCT finds no valid solid in it.
TopoDS_Shape solidOfMesh(const Mesh&, const Progress& = Progress::none());

}  // namespace blossom::modeling
