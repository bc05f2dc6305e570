#pragma once
#include <vector>

#include "geometry/bspline/curve.h"
#include "geometry/shape/shape.h"

namespace blossom::sweep {

/// Kinds of shapes that can be one curve.
inline const std::vector<ShapeKind> curveKinds = {ShapeKind::Curve, ShapeKind::Curves, ShapeKind::Region, ShapeKind::Brep};

/// The one curve of a shape: a curve itself, the one path of a drawing, the one loop of a region, the one wire or edge of a
/// file; with edges (numbered as in geometry/occt/sub_shape.h) those of a solid, a file or a drawing, in any order. Its
/// parts are joined exactly, each over a range of the parameter as long as its poles' polygon.
/// @param what of the message: "path", "profile"
/// @throws Error InvalidInput when there is none or more than one, or its parts do not meet; NotFound for an edge that the
/// shape has not.
Curve curveOf(const Shape&, const char* what, const std::vector<int>& edges = {});

}  // namespace blossom::sweep
