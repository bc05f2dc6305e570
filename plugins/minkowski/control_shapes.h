#pragma once
#include <utility>
#include <vector>

#include "feature/feature_type.h"
#include "geometry/planar/single_point.h"
#include "kernel/morph/point_shape.h"

namespace blossom::minkowski {

/// What morphs: the regions of the first input, and points among them as regions of point_shape.h.
inline std::vector<Region> controlShapesOf(const Inputs& inputs) {
  std::vector<Region> shapes;
  for (const Shape& shape : inputs.of(0)) {
    const auto* drawing = shape.get<Curves>();
    const auto point = drawing ? singlePoint(drawing->paths) : std::nullopt;
    if (point)
      shapes.push_back(pointRegion(*point));
    else if (const auto* region = shape.get<Region>())
      shapes.push_back(*region);
    else
      throwWrongKind(shape);
  }
  return shapes;
}

/// A control shape or in-between as a shape: a point as a drawing.
inline Shape shapeOfControl(Region region) {
  if (const auto point = pointIn(region)) return Shape(pointDrawing(*point));
  return Shape(std::move(region));
}

}  // namespace blossom::minkowski
