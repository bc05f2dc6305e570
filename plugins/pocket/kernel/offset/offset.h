#pragma once
#include "kernel/offset/clearance_diagram.h"

namespace blossom::pocket {

struct OffsetOptions {
  double distance = 1;  ///< mm, above 0
  Side side = Side::Inside;
  double tolerance = 1e-3;  ///< mm, maximum error of the distance
};

struct OffsetResult {
  Region region;               ///< loops of lines and arcs, outer ccw, holes cw; empty when nothing is left
  double largestDistance = 0;  ///< mm, maximum inside distance with a result that is not empty
};

/// One offset of a region. For several distances build a ClearanceDiagram.
/// @throws Error as ClearanceDiagram and its `offset`.
OffsetResult offset(const Region&, const OffsetOptions&, const Progress& = Progress::none());

}  // namespace blossom::pocket
