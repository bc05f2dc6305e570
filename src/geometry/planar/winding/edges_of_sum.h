#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/polygons/grid.h"
#include "geometry/planar/winding/convolution.h"
#include "geometry/planar/winding/winding_faces.h"

namespace blossom::planar {

/// Edges whose winding number is positive exactly inside A + B: the convolution without what certainly lies inside, or,
/// where there are fewer than a million and that is less than half of them, the whole. @throws Error as convolution and
/// certainInside
/// @param inside what is read off them: elsewhere than where it is positive, the whole convolution is needed
std::vector<CountedEdge> edgesOfSum(std::span<const GridPolygon> a, std::span<const GridPolygon> b, Inside inside,
                                    const Progress&, const Effort&, PairSources* sources = nullptr);

}  // namespace blossom::planar
