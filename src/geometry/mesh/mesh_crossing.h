#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/mesh/mesh.h"
#include "geometry/mesh/triangle_distance.h"

namespace blossom {

/// Two faces of a mesh that meet elsewhere than in the vertex or the edge they share.
struct MeshCrossing {
  Vec3 place;                         ///< in both faces, rounded to doubles
  std::size_t first = 0, second = 0;  ///< faces, first <= second; the same face twice when it crosses itself
};

/// The crossing of the lowest first face, and among those of the lowest second; nothing when no two faces meet anywhere else
/// than in what they share. Decided by exact predicates on the coordinates as they are. Corners at one place are one vertex,
/// whatever their indices, so faces that only touch in a common corner or along a whole common edge do not cross; a corner
/// that lies on another face or within another edge does. Polygons count as the triangles of `triangulated`; triangles
/// without area are left out. Open and closed meshes alike. O(n log n) for surfaces that seldom come near themselves.
/// Hand-written because CGAL's self_intersections knows corners by their indices alone.
/// @throws Error InvalidInput for a face that names no vertex and for coordinates that are no numbers, Cancelled.
std::optional<MeshCrossing> firstCrossing(const Mesh&, const Progress& = Progress::none());

/// Whether the crossing of two triangles is one that counts.
using CrossingJudge = std::function<bool(const Triangle3&, const Triangle3&)>;

/// One crossing that counts of each triangle that has any with one behind it, in their order.
std::vector<MeshCrossing> crossings(const Mesh&, const CrossingJudge&, const Progress& = Progress::none());

}  // namespace blossom
