#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/fitting/true_curve.h"
#include "geometry/planar/polygons/grid.h"
#include "geometry/planar/region.h"
#include "geometry/planar/winding/boundary_rings.h"

namespace blossom::planar {

/// A side of a ring of polygons: the curve it stands for, nothing where that is smaller than the rounding.
using CurveOfEdge = std::function<std::optional<TrueCurve>(std::uint32_t edge)>;

struct CurveFitting {
  double rounding = 0;  ///< mm within which points are one
  double reach = 0;     ///< mm from a corner of the polygons to the same corner on the curves, at most
  double gap = 0;       ///< mm between the ends of curves that miss each other, at most
  double closed = 0;    ///< mm between such ends that a line joins; farther apart, the curves do not fit
};

/// Parts bounded by the curves that the sides of rings stand for: sides of one curve become one segment, and where the curve
/// changes the corner moves to the point in which both curves meet. Nothing when the curves do not meet near a corner, or
/// when what comes out crosses itself: then the polygons are too coarse for the curves. O(n log n), and O(n) more for every
/// side that turns out to run backward. @throws Error Cancelled.
std::optional<Region> fittedCurves(const std::vector<TracedPart>&, const Grid&, const CurveOfEdge&, const CurveFitting&,
                                   const Progress& = Progress::none());

/// Parts bounded by the sides of the rings themselves.
Region straightRegion(const std::vector<TracedPart>&, const Grid&);

}  // namespace blossom::planar
