#pragma once
#include <span>
#include <vector>

#include "core/vector.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// The convex hull as closed triangles over its corners; without faces when the points lie in a plane. Decided by exact
/// predicates.
Mesh hullTriangles(const std::vector<Vec3>& points);

/// 1 where d lies on the side from which a b c is seen counter-clockwise, -1 on the other one, 0 in the plane of them;
/// exactly.
int sideOfPlane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// {x : x + p inside the hull for every p of `points`}: its planes are moved inwards, exactly; corners are then rounded to
/// doubles. Without faces when nothing of volume is left. @pre a hull of hullTriangles
Mesh shrunk(const Mesh& hull, std::span<const Vec3> points);

}  // namespace blossom::morphology
