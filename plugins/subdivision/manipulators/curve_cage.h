#pragma once
#include <memory>
#include <optional>

#include "cage_input.h"
#include "kernel/limit_shape.h"

namespace blossom::subdivision {

/// A control polygon, or the poles of a B-spline curve, and the limit curve that they have.
struct CurveCage {
  std::vector<Vec3> points;
  std::unique_ptr<LimitShape> curve;
  std::vector<Foot> joints;  ///< where two pieces of the limit curve meet, and its ends: one for about each control point
  bool closed = false;
};

/// As a deformation understands the shape. @throws Error InvalidInput when it is no cage of a curve.
CurveCage curveCage(const Shape&, Chosen);

/// The control points alone.
std::vector<Vec3> controlPoints(const Shape&, Chosen);

}  // namespace blossom::subdivision
