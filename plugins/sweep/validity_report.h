#pragma once
#include <optional>
#include <string>

#include "feature/feature_type.h"
#include "geometry/bspline/surface.h"
#include "geometry/shape/motion.h"
#include "kernel/solid.h"

namespace blossom::sweep {

/// Adds to a result how far the swept surface is from folding, from weights that are not positive and from crossing itself,
/// and how exactly it follows its motion: figures `crosses_itself`, `crossing_depth` and `export_deviation` of `result`;
/// stats `min_normal`, `min_normal_share` (of the largest), `min_normal_at` (u, v), `min_normal_place` (mm),
/// `min_weight_at`, `min_weight_place`, and of a crossing `crossing_place`, `crossing_first_at`, `crossing_second_at`; a
/// warning with place, cause and remedy for each of what is wrong, a crossing before all others and a fold next. Where the
/// surface folds over itself, `crosses_itself` is true or left out: sheets that lie on each other do not cross, and are not
/// sound either.
/// @param surface of the result  @param deviation mm, of a cubic surface from the motion, measured when it was made; else it
/// is measured here, and the surface is the rational one with weights
/// @throws Error Cancelled
void addValidity(const Motion&, const Surface& surface, std::optional<double> deviation, Evaluated&, const Progress&);

/// The same for a solid over the surface, which does not cross itself: it would have been refused.
/// @throws Error Degenerate as refuseHollowRing; Cancelled
void addValidityOfSolid(const Motion&, const Surface& surface, const SolidResult&, std::optional<double> deviation,
                        Evaluated&, const Progress&);

/// Refuses a solid whose ends meet and whose sections go back somewhere, as those of a torus that are wider than its ring.
/// What they pass there they take away: it would be a void inside of the solid, which no crossing tells.
/// @throws Error Degenerate with place, cause and remedy; Cancelled
void refuseHollowRing(const Motion&, const SolidResult&, const Progress&);

}  // namespace blossom::sweep
