#pragma once
#include "core/progress.h"
#include "kernel/effort.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// A + B = {a + b}, regularised; empty when A or B is. Both are rounded to a grid of 2^-46 of the larger extent, the rest is
/// exact; loops have no collinear points and no parts of the size of the grid. Two convex sets are merged by the angles of
/// their edges in O(n + m); otherwise the result is the set of positive winding numbers of the convolution (see
/// convolution.h).
/// @param effort limit on the work; sums of convex sets do not count
/// @throws Error LimitExceeded, Cancelled; TooMuchWork.
Polygons sum(const Polygons& a, const Polygons& b, const Progress&, Effort& effort);
Polygons sum(const Polygons& a, const Polygons& b, const Progress& = Progress::none());

/// {p : p + B inside A} = complement of (complement of A) + (-B), regularised: parts that collapse to lines and points are
/// left out, and the result may be empty. @pre B is not empty. @throws as sum.
Polygons difference(const Polygons& a, const Polygons& b, const Progress&, Effort& effort);

}  // namespace blossom::minkowski
