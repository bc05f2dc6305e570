#pragma once
#include <optional>
#include <string>

#include "kernel/outline/outline_sides.h"
#include "parameter/written.h"

/// A drawn outline has no lengths of its own: one that is typed as an expression stays as such in the coordinates that move
/// with the side, each written as the one where the side begins, plus or minus the expression.
namespace blossom::modeling {

/// Along which axis a side runs, 0 or 1; empty: it is slanted, and no coordinate can hold its length.
std::optional<int> axisOf(const StraightSide&);

/// The expression that the length of a side is written as; empty when there is none.
/// @param written parameters of the feature, as the document keeps them
std::string writtenLength(const Value& written, const DrawnOutline&, const StraightSide&);

/// A side that got another length.
struct SideEdit {
  const DrawnOutline& before;
  const DrawnOutline& after;
  const DrawnOutline& moved;  ///< differs from `before` in every point that goes with the side, also if its length stays
  StraightSide side;          ///< of `before`
  std::string length;         ///< the expression for it, along an axis; empty: a number was typed
};

/// The parameters after the edit, with the expressions that belong there: of the length, and those that the coordinates had.
/// @param next those with plain numbers where something has moved
Value withExpressions(Value next, const Value& written, const SideEdit&, const NamedNumbers&);

}  // namespace blossom::modeling
