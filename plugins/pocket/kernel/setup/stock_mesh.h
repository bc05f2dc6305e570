#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/setup/stock_field.h"

namespace blossom::pocket {

/// The closed surface of what stands: through the middles of the cells on top, flat below. Where nothing stands there is
/// nothing; a step from cell to cell is a slope of one cell's breadth. Empty when nothing stands at all. O(cells).
Mesh meshOf(const StockField&);

}  // namespace blossom::pocket
