#pragma once
#include "core/progress.h"
#include "geometry/planar/polygons/polygons.h"

namespace blossom::minkowski {

using namespace planar;

struct FilledDents {
  Polygons shape;
  double depth = 0;  ///< largest distance from A of what was filled, at most
};

/// Fills dents of the boundary that are nowhere deeper than `depth`, or that take up no more than twice that along the
/// line over them: a chain of edges to the left of the straight line between its ends is replaced by the line. With A the
/// set and D the disc of that radius, the result lies between A and A + D. Sums have many such dents where they add up many
/// shapes. About O(n).
/// @pre the loops of A do not cross
/// @throws Error Cancelled
FilledDents withoutShallowDents(const Polygons&, double depth, const Progress& = Progress::none());

}  // namespace blossom::minkowski
