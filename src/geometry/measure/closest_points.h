#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/triangle_distance.h"

namespace blossom {

/// The nearest points of two B-rep shapes (vertices, edges, faces, solids and compounds of them). Every pair of a face, edge
/// or vertex of one with one of the other is sampled, and from the best samples Newton's method finds the nearest points of
/// the exact curves and surfaces, so that the distance is exact to rounding. Pairs whose boxes lie farther apart than the
/// best points known are passed over. Solids are full: what lies inside has distance 0. Where many points are equally near,
/// those in the middle are taken.
/// @throws Error InvalidInput when nothing is there or a part is unbounded, Cancelled.
FootPoints closestPoints(const TopoDS_Shape&, const TopoDS_Shape&, const Progress&);

/// One point of each connected part: of each solid, free face, free edge and free vertex.
std::vector<Vec3> representatives(const TopoDS_Shape&);
/// The first of `points` that lies in a solid of the shape, its boundary left out.
std::optional<Vec3> pointInside(const std::vector<Vec3>& points, const TopoDS_Shape&, const Progress&);

}  // namespace blossom
