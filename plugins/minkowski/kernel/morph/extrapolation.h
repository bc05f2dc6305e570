#pragma once
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
/// compared, to 1e-9 of their size, of splines to the tolerances; the deviation is what was found.
/// @throws as sum and difference of curved_sum.h
std::optional<InBetween> continuedTo(std::span<const double> t, std::span<const SoundRegion> shapes, Adder&,
                                     const Progress&);

/// The t nearest to the given one, beyond the ends, at which there is a shape, to a thousandth of the way; the end itself
/// when there is none.
double farthestTowards(double t, std::span<const SoundRegion> shapes, Adder&, const Progress&);

}  // namespace blossom::minkowski
