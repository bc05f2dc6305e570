#pragma once
#include <functional>
#include <optional>
#include <span>

#include "core/progress.h"
#include "geometry/planar/polygons/sound_region.h"
#include "kernel/morph/expansion.h"
#include "kernel/morph/repetition.h"

namespace blossom::minkowski {

/// Whether a number is beyond the first or the last shape, where weights are negative.
bool isBeyond(std::span<const double> t);

/// The morph of control shapes beyond its ends. In the explicit form (Lee, Lee, Kim & Kim 2002, equation 4.6) the terms of
/// negative weight are taken away from the others: C is the largest shape with C + N = P, where P is the sum of the terms of
/// positive weight and N that of |w| A for the others. Of convex shapes this continues the support functions, so that
/// C(t) + (t-1) A = t B.
/// @returns nothing when no shape C has that sum: the largest one inside, P - N, is added to N again, and the outlines are
/// compared, to 1e-9 of the size of C and the rounding of P, of splines to an eighth of the
/// tolerances, by which sides may move corners.
/// The deviation is what was found, where that is beyond rounding. Nothing either when P is so much larger than C that its
/// rounding would hide a difference.
/// @throws Error LimitExceeded for too many different numbers of shapes that are not convex; as sum and difference of
/// curved_sum.h
std::optional<InBetween> continuedTo(std::span<const double> t, std::span<const SoundRegion> shapes, Adder&,
                                     const Progress&);

/// A t beyond an end, towards the given one, at which there is a shape, found by halving the way ten times; the end itself
/// when there is none. Of convex shapes it is the farthest one, for theirs form an interval.
double farthestTowards(double t, const std::function<bool(double)>& isThere, const Progress&);

}  // namespace blossom::minkowski
