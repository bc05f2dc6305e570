#pragma once
#include <Poly_Triangulation.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <map>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/tessellate/tessellate.h"

namespace blossom {

/// Unit normals along du x dv in a face's own frame, one per node.
using GridNormalsOf = std::map<const Poly_Triangulation*, std::vector<Vec3>>;

/// Stores, for those of the faces that `gridFace` recognises, a triangulation within the chord, and for their edges polygons
/// on it with parameters. An edge between two such faces has the points required by both. The stored deflection is 0, so
/// that BRepMesh keeps these triangulations and joins neighbouring faces to their edges.
/// @param faces of a shape that no other thread reads meanwhile
GridNormalsOf meshGridFaces(const TopTools_IndexedMapOfShape& faces, const TessellationOptions&, const Progress&);

}  // namespace blossom
