#pragma once
#include <memory>
#include <optional>

#include "cage_input.h"
#include "kernel/limit_shape.h"

namespace blossom::subdivision {

/// A control polygon, or the poles of a B-spline curve, with its limit curve.
struct CurveCage {
  std::vector<Vec3> points;
  std::unique_ptr<LimitShape> curve;
  std::vector<Foot> joints;  ///< joints between pieces of the limit curve, and its ends: about one per control point
  bool closed = false;
};

/// The cage as a deformation interprets the shape. @throws Error InvalidInput when it is no cage of a curve.
CurveCage curveCage(const Shape&, SchemeChoice);

/// The control points alone.
std::vector<Vec3> controlPoints(const Shape&, SchemeChoice);

}  // namespace blossom::subdivision
