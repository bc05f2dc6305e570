#pragma once
#include "kernel/offset/clearance_diagram.h"

namespace blossom::pocket {

struct OffsetOptions {
  double distance = 1;  ///< mm, above 0
  Side side = Side::Inside;
  double tolerance = 1e-3;  ///< mm, most that a point of the result may be off the distance
};

struct OffsetResult {
  Region region;               ///< loops of lines and arcs, outer ccw, holes cw; empty when nothing is left
  double largestDistance = 0;  ///< mm, up to which something is left inside
};

/// One offset of a region. Whoever needs several distances builds a ClearanceDiagram.
/// @throws Error as ClearanceDiagram and its `offset` do.
OffsetResult offset(const Region&, const OffsetOptions&, const Progress& = Progress::none());

}  // namespace blossom::pocket
