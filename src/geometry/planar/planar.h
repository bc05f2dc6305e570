#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "core/tolerance.h"
#include "geometry/bspline/curve.h"
#include "geometry/planar/region.h"

namespace blossom {

Vec2 startPoint(const Segment&);
Vec2 endPoint(const Segment&);
Vec2 startPoint(const Path&);
Vec2 endPoint(const Path&);
/// The same points in reverse order.
Segment reversed(const Segment&);
Path reversed(const Path&);
/// Arc length in mm, for smooth splines with a relative error of 1e-12.
double length(const Segment&);
double length(const Path&);
/// Polyline within `chord` mm of the segment, both ends included.
/// @throws Error InvalidParameter when chord is not positive.
std::vector<Vec2> flatten(const Segment&, double chord);
/// Polyline of a path; the first point is not repeated at the end of a closed one.
std::vector<Vec2> flatten(const Path&, double chord);
/// Area to the left of a closed path by Green's formula, exact for lines and arcs, Gauss quadrature for splines; negative
/// when clockwise.
double signedArea(const Path&);
double area(const Region&);

/// A planar spline as a curve in z = 0, and back (z is dropped).
Curve toCurve(const Spline2&);
Spline2 toSpline(const Curve&);

/// Elliptic arc as an exact rational quadratic spline. `axis` is the half-axis vector at angle 0, `ratio` the length of the
/// other half-axis divided by that of `axis` (negative for a clockwise ellipse). Angles in radians of the ellipse's own
/// parameter.
Spline2 ellipticArc(const Vec2& center, const Vec2& axis, double ratio, double start, double sweep);
/// Affine image: arcs remain arcs under similarities and become splines otherwise.
/// @throws Error Degenerate when the map is singular.
Segment transformed(const Segment&, const Eigen::Matrix<double, 2, 3>& affine);
Path transformed(Path, const Eigen::Matrix<double, 2, 3>& affine);

/// Joins open paths whose ends are within `tolerance.joining` into longer ones and closes those whose ends meet, in file
/// order. Where several ends meet, the nearest one of the same layer is joined. O(n log n).
Curves joined(const Curves&, const Tolerance& = {});

/// Winding number of a closed path around a point, counter-clockwise positive. Exact geometry: lines, arcs and splines are
/// subdivided only near the point. Undefined for points on the path.
int windingNumber(const Path&, const Vec2& point);
/// A point inside a closed path that does not cross itself, away from the path. Where it touches itself, in what it turns
/// around as its signed area does: a hole that touches an island in a corner, in one path, is mostly hole. @throws Error
/// Degenerate when the path encloses nothing.
Vec2 interiorPoint(const Path&);

/// The region enclosed by closed paths under their fill rule. Open paths are joined first. Loops must not cross.
/// @throws Error InvalidInput with the place when a path is open or nothing is enclosed.
Region toRegion(const Curves&, const Tolerance& = {});
Curves toCurves(const Region&);

/// An outer loop and the holes in it, as indices of loops.
struct RegionComponent {
  std::size_t outer = 0;
  std::vector<std::size_t> holes;
};
/// The connected parts of a region, in the order of their outer loops.
std::vector<RegionComponent> components(const Region&);

}  // namespace blossom
