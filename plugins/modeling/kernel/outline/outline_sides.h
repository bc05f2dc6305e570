#pragma once
#include <optional>
#include <vector>

#include "kernel/outline/outline_drawn.h"

namespace blossom::modeling {

/// A line of a drawn outline, also the one that closes it.
struct StraightSide {
  int segment = 0;  ///< index; the number of segments means the line that closes the outline
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  Vec2 outward = Vec2::UnitY();  ///< unit normal, away from the inside of a closed outline
};

/// The lines that have a length, in order.
std::vector<StraightSide> straightSides(const DrawnOutline&);

/// The outline with a line of another length. Its end moves along it, and what follows moves with it, up to the first line
/// that is parallel to it and takes up the difference: all angles stay, a rectangle stays one. Where no line does, only the
/// end of the line moves; of an open outline, the rest moves. Coordinates come without the dirt of rounding. Empty when the
/// segment is no line, or when the result would be no sound outline. O(segments).
/// @param length mm, above 0
std::optional<DrawnOutline> withSideLength(const DrawnOutline&, int segment, double length);

}  // namespace blossom::modeling
