#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/morph/morph.h"

namespace blossom::minkowski {

/// A B-spline whose poles are shapes.
struct ShapeKnots {
  int degree = 1;
  std::vector<double> knots;  ///< as many as shapes and the degree and one more; the first and last degree + 1 are equal
  friend bool operator==(const ShapeKnots&, const ShapeKnots&) = default;
};

/// Evenly spaced knots, with the ends as often as needed for the spline to begin at the first shape and end at the last.
/// With one shape more than the degree it is the Bézier morph.
ShapeKnots uniformKnots(std::size_t shapes, int degree);

/// The knots of a morph of these parameters: those given, which tell the degree where that is 0; else evenly spaced ones of
/// the degree, which is one less than the number of shapes where it is 0. @throws as checkKnots
ShapeKnots knotsFor(std::size_t shapes, int degree, const std::vector<double>& knots);

/// @throws Error InvalidParameter: a degree below 1 or above shapes - 1, a wrong number of knots, knots that fall, ends that
/// are not as often there as they must be, a knot inside more often than the degree.
void checkKnots(const ShapeKnots&, std::size_t shapes);

/// How often what is linear in the shapes, such as support functions and the places of convex shapes' edges, is continuously
/// differentiable at the knots inside: the degree less the multiplicity. Nothing when there is no knot inside. The shapes
/// themselves change continuously in any case.
std::optional<int> continuityOf(const ShapeKnots&);

/// The share that each shape has at t, 0 to 1 from the first knot to the last: the basis functions N_i, in Bézier morphs the
/// Bernstein polynomials (Cox 1972, de Boor 1972); of blossoms see
/// sharesOf in evaluation_order.h. They add up to 1. O(shapes + degree^2)
std::vector<double> influences(const ShapeKnots&, double t);

/// In-betweens of shapes by de Boor's algorithm with Minkowski sums instead of sums of points. An in-between depends on
/// degree + 1 shapes. degree (degree + 1) / 2 sums at most; degree when all of these shapes are convex, for their multiples
/// add up. Evaluation and elevation of the options are not used. @throws as morph
MorphResult splineMorph(std::span<const Region> shapes, const ShapeKnots&, std::span<const double> times,
                        const MorphOptions& = {}, const Progress& = Progress::none());

}  // namespace blossom::minkowski
