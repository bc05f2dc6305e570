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

/// Gives those of the faces that `gridFace` knows a triangulation within the chord, and their edges polygons on it, with
/// parameters. An edge of two such faces has the points that both need. The deflection stored is 0: BRepMesh keeps these
/// triangulations as they are and meets their edges from the neighbouring faces.
/// @param faces of a shape that nobody else reads meanwhile
GridNormalsOf meshGridFaces(const TopTools_IndexedMapOfShape& faces, const TessellationOptions&, const Progress&);

}  // namespace blossom
