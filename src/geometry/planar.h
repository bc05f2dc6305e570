#pragma once
#include <array>
#include <vector>

#include "core/tolerance.h"
#include "geometry/region.h"

namespace blossom {

Vec2 startPoint(const Segment&);
Vec2 endPoint(const Segment&);
/// The same points run through in the other direction.
Segment reversed(const Segment&);
Path reversed(const Path&);
double length(const Segment&);
double length(const Path&);
/// Polyline within `chord` mm of the segment, both ends included.
std::vector<Vec2> flatten(const Segment&, double chord);
/// Polyline of a path; the first point is not repeated at the end of a closed one.
std::vector<Vec2> flatten(const Path&, double chord);
/// Area to the left of a closed path by Green's formula, exact for lines and arcs, Gauss quadrature for splines; negative when clockwise.
double signedArea(const Path&);
double area(const Region&);

/// Elliptic arc as an exact rational quadratic spline. `axis` is the half-axis vector where the angle is 0, `ratio` the length of
/// the other half-axis over it (negative for a clockwise ellipse). Angles in radians of the ellipse's own parameter.
Spline2 ellipticArc(const Vec2& center, const Vec2& axis, double ratio, double start, double sweep);
/// Affine image: arcs stay arcs under similarities and become splines otherwise.
Segment transformed(const Segment&, const Eigen::Matrix<double, 2, 3>& affine);
Path transformed(const Path&, const Eigen::Matrix<double, 2, 3>& affine);

/// Joins open paths whose ends meet within `tolerance.joining` into longer ones, and closes those that come back. Keeps file order.
Curves joined(const Curves&, const Tolerance& = {});
/// Area enclosed by the closed paths by their fill rule. Loops must not cross.
/// @throws Error InvalidInput naming the place when a path is open or nothing is enclosed.
Region toRegion(const Curves&, const Tolerance& = {});
Curves toCurves(const Region&);

}  // namespace blossom
