#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/vector.h"
#include "parameter/value.h"

namespace blossom::modeling {

/// The property set by a handle of an outline feature.
enum class HandleRole { Centre, Size, Corner, Rounding };

struct ShapeHandle {
  Vec2 at = Vec2::Zero();
  HandleRole role = HandleRole::Centre;
};

/// The handles of a circle, ellipse, polygon, star, rectangle, slot or text with these (complete, canonical) parameters; the
/// first one moves the whole shape.
std::vector<ShapeHandle> shapeHandles(const std::string& featureType, const Value& parameters);

/// The parameters after dragging a handle to a position, so that the shape passes through it as far as its kind allows.
/// Corners of rectangles and ends of slots leave the opposite one unchanged. Empty when a size would vanish.
std::optional<Value> draggedHandle(const std::string& featureType, const Value& parameters, std::size_t handle,
                                   const Vec2& to);

/// A length of such a shape that is a parameter, and where it is shown.
struct ShapeDimension {
  Vec2 at = Vec2::Zero();
  Vec2 beside = Vec2::UnitY();  ///< unit length, away from the shape
  std::string parameter;
  bool radius = false;
};
std::vector<ShapeDimension> shapeDimensions(const std::string& featureType, const Value& parameters);

/// The feature types with handles.
const std::vector<std::string>& typesWithHandles();

}  // namespace blossom::modeling
