#pragma once
#include <optional>

#include "geometry/shape/shape.h"
#include "kernel/limit_curve.h"
#include "scheme_choice.h"

namespace blossom::subdivision {

/// The cage of an input: the outline of a region as drawn lines, other shapes unchanged.
Shape cageOf(const Shape& input);

/// The control polygon given by drawn lines or a curve of degree 1. Empty for a B-spline curve of higher degree that is its
/// own limit curve: with Catmull-Clark's scheme, with the cubic one for degree 3 and with the quadratic one for degree 2;
/// for other schemes its poles are the control polygon. @throws Error InvalidInput when it is not one polygon of straight
/// lines.
std::optional<ControlPolygon> polygonOf(const Shape&, SchemeChoice);

/// The polygon as a shape of the kind of `like`: drawn lines, or a curve of degree 1. Lines that leave the plane of the
/// drawing become a curve.
Shape shapeOf(const ControlPolygon&, const Shape& like);

/// A cubic or other B-spline curve whose poles can be control points. @throws Error InvalidInput when it has weights.
const Curve& splineOf(const Shape&);

/// Refuses a mesh for the schemes of curves and a curve for Loop's. @throws Error InvalidInput.
void checkScheme(const Shape& cage, SchemeChoice);

}  // namespace blossom::subdivision
