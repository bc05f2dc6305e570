#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/convolution.h"
#include "kernel/effort.h"
#include "kernel/grid.h"

namespace blossom::minkowski {

/// Edges whose winding number is positive exactly inside A + B: the convolution without what certainly lies inside, or,
/// where there are fewer than a million and that is less than half of them, the whole. @throws Error as convolution and
/// certainInside
std::vector<CountedEdge> edgesOfSum(std::span<const GridPolygon> a, std::span<const GridPolygon> b, const Progress&,
                                    const Effort&, PairSources* sources = nullptr);

}  // namespace blossom::minkowski
