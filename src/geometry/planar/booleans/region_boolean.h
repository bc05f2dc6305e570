#pragma once
#include <optional>
#include <span>

#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom {

enum class BooleanOperation { Union, Difference, Intersection };

/// The union of regions of lines and arcs, the first one without all others, or what all have in common; without loops when
/// nothing is left. Its segments lie on those of the regions, whole where no other one cuts them, and end where two of their
/// curves meet. Walls and arcs in common, and points within 2^-34 of the size, are one. Every loop
/// begins at the earliest corner of the regions that it has.
/// Which pieces bound the result is read off winding numbers of polygons through all crossings of the curves (see
/// winding/winding_faces.h). It counts only if every crossing away from the ends of segments has become a corner, every
/// corner is where its curves meet, nothing crosses, and every piece passes boundsAsItShould; else the polygons become
/// finer, and in the end nothing is returned. So it is where a region has splines, loops that cross each other or gaps, arcs
/// of more than 1000 times the size, and where crossings are too flat to tell: ask OCCT then. O((n + k) log n) for k
/// crossings of well-spread segments.
/// @throws Error Cancelled
std::optional<Region> combined(std::span<const Region>, BooleanOperation, const Progress& = Progress::none());

}  // namespace blossom
