#pragma once
#include <vector>

#include "core/progress.h"
#include "kernel/setup/stock_field.h"

namespace blossom::pocket {

/// A move of which a part of the tool is in material where it must not be: the cutter during a rapid, what carries it
/// always.
struct StockHit {
  std::size_t move = 0;
  ToolPart part = ToolPart::Flutes;
  Vec3 at = Vec3::Zero();  ///< in the material
};

/// Carves the stock move by move and looks before each what stands in the way, by more than `allowed` mm. At most one hit
/// for each move and part of the tool. Arcs are followed within a quarter of a cell. @throws Error Cancelled.
std::vector<StockHit> carve(StockField&, const Toolpath&, const ToolAssembly&, double allowed, const Progress&);

/// Removes what the program cuts from one time to another, as shares of all its time; where a cut has no feed, of its
/// length.
/// @throws Error Cancelled.
void cutBetween(StockField&, const Toolpath&, double from, double to, const Progress&);

}  // namespace blossom::pocket
