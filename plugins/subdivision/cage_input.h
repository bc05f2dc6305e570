#pragma once
#include <optional>

#include "geometry/shape/shape.h"
#include "kernel/limit_curve.h"
#include "scheme_choice.h"

namespace blossom::subdivision {

/// What is used of an input: of a region its outline, as drawn lines.
Shape cageOf(const Shape& input);

/// The control polygon that drawn lines, or a curve of degree 1, are. A B-spline curve of a higher degree is a limit curve
/// itself: none of Catmull-Clark's scheme, of the cubic one for degree 3 and of the quadratic one for degree 2; for other
/// schemes its poles are the control polygon. @throws Error InvalidInput when it is not one polygon of straight lines.
std::optional<ControlPolygon> polygonOf(const Shape&, Chosen);

/// The polygon as a shape of the kind that `like` is: drawn lines, or a curve of degree 1. Lines that leave the plane of the
/// drawing are a curve.
Shape shapeOf(const ControlPolygon&, const Shape& like);

/// A cubic or other B-spline curve whose poles can be control points. @throws Error InvalidInput when it has weights.
const Curve& splineOf(const Shape&);

/// Refuses a mesh for the schemes of curves and a curve for Loop's. @throws Error InvalidInput.
void checkScheme(const Shape& cage, Chosen);

}  // namespace blossom::subdivision
