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

/// Two faces of a mesh that intersect outside the vertex or edge they share.
struct MeshCrossing {
  Vec3 place;                         ///< a common point, rounded to doubles
  std::size_t first = 0, second = 0;  ///< faces, first <= second; the same face twice when it crosses itself
};

/// The intersection with the lowest first face and then the lowest second face; empty when faces meet only in what they
/// share. Decided by exact predicates on the given coordinates. Corners at the same position are the same vertex whatever
/// their indices, so faces that touch in a common corner or along a whole common edge do not intersect; a corner on another
/// face or inside another edge counts as an intersection. Polygons are represented by the triangles of `triangulated`;
/// triangles without area are ignored. For open and closed meshes. O(n log n) for surfaces with few close parts.
/// @throws Error InvalidInput for a vertex index out of range and for coordinates that are not finite, Cancelled.
std::optional<MeshCrossing> firstCrossing(const Mesh&, const Progress& = Progress::none());

/// Whether the intersection of two triangles counts.
using CrossingJudge = std::function<bool(const Triangle3&, const Triangle3&)>;

/// For each triangle that has intersections which count with later triangles, one of them; in the order of the triangles.
std::vector<MeshCrossing> crossings(const Mesh&, const CrossingJudge&, const Progress& = Progress::none());

}  // namespace blossom
