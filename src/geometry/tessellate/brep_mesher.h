#pragma once
#include <TopoDS_Shape.hxx>
#include <vector>

#include "core/progress.h"
#include "geometry/tessellate/tessellate.h"

namespace blossom {

/// Triangles of one OCCT shape with its edges and vertices, all numbered in the order of TopExp::MapShapes. Points on an
/// edge have the same coordinates in all adjacent faces, so that the triangles of a closed shell are closed. Meshes a copy:
/// the shape itself gets no triangulation and may be read by other threads meanwhile.
/// @throws Error Degenerate when no face can be triangulated, Cancelled.
Tessellation meshShape(const TopoDS_Shape&, const TessellationOptions&, const Progress&);

}  // namespace blossom
