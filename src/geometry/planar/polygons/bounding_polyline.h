#pragma once
#include "core/progress.h"
#include "geometry/planar/polygons/polygons.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// Corners of a polyline within `tolerance` mm of a closed path and nowhere to the left of it, up to rounding, so that it
/// cuts nothing off the left side of the path. Parts that bend to the right are approximated by chords, parts that bend to
/// the left by tangents: tangents of an arc, and the end tangents of spline pieces with a convex control polygon, because
/// such a piece lies in the triangle of its chord and end tangents. A piece that bends both ways is bounded by an oriented
/// box of its poles, and so are the pieces around a cusp, a millionth of their spline.
Loop polylineToTheRight(const Path&, double tolerance, const Progress& = Progress::none());
/// The same, nowhere to the right of the path.
Loop polylineToTheLeft(const Path&, double tolerance, const Progress& = Progress::none());

}  // namespace blossom::planar
