#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"

/// What is left of a surface after its corners have been rounded, of which none has moved farther than some mm.
namespace blossom::morphology {

/// Whether as much is enclosed, and by no more surface: a face whose triangles fold back over each other has more.
/// @param before triangles @param size of it
bool keepsVolume(const Mesh& before, const Mesh& after, double size, double moved, const Progress&);

/// Whether the triangles that readers make of a polygon fold back over each other, by more than strips along its sides, as
/// wide as corners have moved. @param size of the mesh
bool foldsBack(const Mesh& polygons, double size, double moved, const Progress&);

/// Whether bodies, holes through them, or surface are gone, which were thinner than what corners have moved.
/// @param before triangles @param size of it
bool losesDetails(const Mesh& before, const Mesh& after, double size, double moved, const Progress&);

/// Whether every triangle of the one surface lies near the other one, but for sheets with less area than strips along their
/// edges, as wide as corners have moved. O(n log n)
/// @param before, after triangles
/// @param isLossTold so closed parts may go that are no thicker, too
bool keepsPlaces(const Mesh& before, const Mesh& after, double moved, bool isLossTold, const Progress&);

}  // namespace blossom::morphology
