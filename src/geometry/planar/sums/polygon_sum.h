#pragma once
#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/polygons/polygons.h"

namespace blossom::planar {

/// A + B = {a + b}, regularised; the empty set when one of them is empty. Both are snapped to a grid of 2^-46 of the larger
/// extent, the rest is exact; loops come without collinear points and without crumbs of the grid's size. Two convex sets
/// are merged by the angles of their edges in O(n + m); others are the faces of positive winding number of their
/// convolution (see convolution.h).
/// Hand-written because CGAL 5.5's Minkowski sums lose holes at times (its reports 5830 and 5839).
/// @param effort what it may cost; convex sets cost nothing
/// @throws Error LimitExceeded, Cancelled; TooMuchWork.
Polygons sum(const Polygons& a, const Polygons& b, const Progress&, Effort& effort);
Polygons sum(const Polygons& a, const Polygons& b, const Progress& = Progress::none());

/// With a square of that half width about the origin: larger by at least as much on all sides. @throws as sum
Polygons grownBy(const Polygons&, double by, const Progress&, Effort& effort);

/// {p : p + B inside A} = complement of (complement of A) + (-B), regularised: parts that collapse to lines and points are
/// left out, and the result may be empty. @pre B is not empty. @throws as sum.
Polygons difference(const Polygons& a, const Polygons& b, const Progress&, Effort& effort);

}  // namespace blossom::planar
