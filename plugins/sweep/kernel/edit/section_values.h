#pragma once
#include <span>
#include <vector>

#include "geometry/bspline/spline_space.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// How far knots that stand for the same value may be apart: 1e-12 of their range, or what rounding leaves of their
/// coordinates where these are much larger than it.
double sameKnot(std::pair<double, double> domain);

/// Knots in u that come back after every n-th of the period, up to sameKnot; so do the functions.
bool knotsRepeat(const SplineSpace& closed, int n);
/// The knots are the same read backwards, up to sameKnot.
bool knotsAreMirrored(const SplineSpace&);

/// Parameters at which two sections, or a section and a copy of it, are compared: degree + 1 inside each piece between the
/// knots and their copies after every n-th of the period, or their mirror images. Splines with the same values there are the
/// same, however unevenly an edit refined one of them.
std::vector<double> placesToCompare(const Surface&, int fold);
std::vector<double> placesToCompareMirrored(const Surface&);

/// The values of a factor at one v. u may lie up to one period beyond the domain of a closed one.
/// @param closure what they are multiplied by then  O((rows + parameters) degree^2).
std::vector<Vec4> sectionValues(const Surface&, double v, std::span<const double> u, double closure);

}  // namespace blossom::sweep
