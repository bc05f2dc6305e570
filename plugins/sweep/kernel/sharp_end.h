#pragma once
#include <vector>

#include "geometry/bspline/surface.h"

namespace blossom::sweep {

/// Whether the section at an end is a straight edge that is run through forth and back, as that of a chisel: no point, and
/// its poles lie on a line within `near`.
bool isSharpEnd(const Surface&, bool atEnd, double near);

/// Where a surface that closes in u is to be cut so that the parts of such an end which lie on each other are edges of
/// different parts: where the end turns back, and opposite to the seam. Ascending, within the domain; O(samples).
/// @throws Error Degenerate when the edge is run through more than once each way
std::vector<double> cutsOfSharpEnd(const Surface&, bool atEnd);

/// The surface in parts, cut at these parameters u, ascending. Each keeps its parameters. A cut next to a knot or to an end
/// of the domain is moved there.
std::vector<Surface> cutAlongV(const Surface&, const std::vector<double>& cuts);

}  // namespace blossom::sweep
