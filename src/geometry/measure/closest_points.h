#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/triangle_distance.h"

namespace blossom {

/// The nearest points of two B-rep shapes (vertices, edges, faces, solids and compounds of them). Every pair of faces, edges
/// and vertices is sampled; from the best samples Newton's method finds the nearest points of the exact curves and surfaces,
/// so the distance is exact up to rounding. Pairs whose boxes are farther apart than the best distance found so far are
/// skipped. Solids count with their interior: the distance to a shape inside is 0. Among equally near points those in the
/// middle are chosen.
/// @throws Error InvalidInput when a shape is empty or unbounded, Cancelled.
FootPoints closestPoints(const TopoDS_Shape&, const TopoDS_Shape&, const Progress&);

/// One point of each connected part: each solid, free face, free edge and free vertex.
std::vector<Vec3> representatives(const TopoDS_Shape&);
/// The first of `points` strictly inside a solid of the shape.
std::optional<Vec3> pointInside(const std::vector<Vec3>& points, const TopoDS_Shape&, const Progress&);

}  // namespace blossom
