#pragma once
#include <vector>

#include "core/progress.h"
#include "kernel/convolution.h"
#include "kernel/grid.h"

namespace blossom::minkowski {

/// Iterated snap rounding (Halperin & Packer 2002): edges that pass within a unit of a vertex are bent through it, crossings
/// become vertices, until edges meet in common end points alone. No vertex moves by more than a few units.
/// @pre edges run from the lower to the higher point and differ
/// @throws Error Cancelled; Internal when it does not come to an end.
std::vector<CountedEdge> snapRounded(std::vector<CountedEdge>, const Progress& = Progress::none());

/// The loops as edges that count once, from the lower to the higher point, equal ones joined.
std::vector<CountedEdge> edgesOf(const std::vector<GridPolygon>&);

/// Whether edges meet in the corners of their own loops alone and nothing else comes within some units of another.
bool isClear(const std::vector<GridPolygon>&, const Progress& = Progress::none());

/// Loops as the convolution needs them: rounding to the grid may have brought thin parts to cross, and a crossing of a
/// single unit turns the winding numbers of a whole sum. Where anything comes within a few units of another, the edges are
/// snap-rounded and read anew; otherwise the loops stay as they are.
std::vector<GridPolygon> untangled(std::vector<GridPolygon>, const Progress& = Progress::none());

}  // namespace blossom::minkowski
