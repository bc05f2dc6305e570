#pragma once
#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// Corners of a polyline that stays within `tolerance` mm of a closed path and has it on its left: nothing of the path's
/// left side is cut off, but for rounding. What bends to the right is followed by chords. What bends to the left is followed
/// by tangents: those of an arc, and those at the ends of spline pieces whose poles form a convex polygon, for such a piece
/// lies in the triangle of its chord and its end tangents. A piece that does both lies in a box of its poles.
/// Pieces around a cusp, a millionth of their spline, count as their poles' box, too.
Loop polylineToTheRight(const Path&, double tolerance, const Progress& = Progress::none());
/// The same with the path on its right.
Loop polylineToTheLeft(const Path&, double tolerance, const Progress& = Progress::none());

}  // namespace blossom::minkowski
