#pragma once
#include <cstddef>

#include "geometry/planar/medial_axis.h"
#include "kernel/medial/boundary.h"
#include "kernel/medial/voronoi_graph.h"

namespace blossom::pocket {

/// A place on a curve of the boundary, as a place of its region. The parameter is brought into [0, 1] first.
BoundaryFoot footAt(const Boundary&, std::size_t curve, double parameter);

/// Where a disc around x touches the site, on the true curves: beyond the end of a curve that another continues smoothly,
/// on that one.
BoundaryFoot footOf(const Boundary&, const Site&, const Vec2& x);

}  // namespace blossom::pocket
