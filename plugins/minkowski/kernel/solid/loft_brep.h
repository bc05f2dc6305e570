#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "geometry/shape/brep.h"

namespace blossom::minkowski {

/// The solid that closed polygons bound, with a planar face for each: triangles of one plane, as which faces with holes
/// come, are joined, unless OCCT fails to, which the volume tells. @throws Error Cancelled
Brep loftBrep(const Mesh&, const Progress& = Progress::none());

}  // namespace blossom::minkowski
