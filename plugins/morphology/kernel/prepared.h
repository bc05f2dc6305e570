#pragma once
#include <string>
#include <vector>

#include "kernel/exact.h"
#include "kernel/operand.h"

namespace blossom::morphology {

/// An operand on the grid of its operation, about its own centre, so that sums of coordinates are exact in doubles and
/// places far from the origin cost no digits.
struct Prepared {
  Solid solid;              ///< nullptr for thinner shapes
  Parts pieces;             ///< of thinner shapes
  bool bodiesMeet = false;  ///< bodies of the solid overlap or touch elsewhere than in common vertices and edges
  Bounds bounds;            ///< about `centre`
  Vec3 centre = Vec3::Zero();
  std::string name;
  std::vector<std::string> warnings;
};

/// Of two operands that are used together.
struct Grid {
  double step = 1;
};
Grid gridFor(const Bounds& a, const Bounds& b);

/// @throws Error InvalidInput for what is no solid, see checkedSolid.
Prepared prepared(const Operand&, const Grid&, const Progress&);

/// Convex parts of a solid, or the pieces that it is.
Parts partsOf(const Prepared&, const Progress&);

}  // namespace blossom::morphology
