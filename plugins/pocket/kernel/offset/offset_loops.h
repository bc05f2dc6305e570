#pragma once
#include "kernel/medial/boundary.h"
#include "kernel/offset/curve_arcs.h"
#include "kernel/offset/offset_trace.h"

namespace blossom::pocket {

struct LoopOptions {
  double distance = 0;
  Side side = Side::Inside;
  double tolerance = 1e-3;  ///< mm, the boundary is flattened to a quarter of it
};

/// A traced loop of the flattened boundary on the true curves: a line for a line, an arc for an arc and for a corner, and
/// circles parallel to the arcs that follow a free-form curve (curve_offset.h); their joints are computed by Newton's
/// iteration.
Path loopOnTrueCurves(const Boundary&, const CurveArcs&, const TracedLoop&, const LoopOptions&);

}  // namespace blossom::pocket
