#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/vector.h"
#include "parameter/value.h"

namespace blossom::modeling {

/// What a handle of an outline feature sets.
enum class HandleRole { Centre, Size, Corner, Rounding };

struct ShapeHandle {
  Vec2 at = Vec2::Zero();
  HandleRole role = HandleRole::Centre;
};

/// The handles of a circle, ellipse, polygon, star, rectangle, slot or text with these parameters (complete, canonical); the
/// first one moves the whole.
std::vector<ShapeHandle> shapeHandles(const std::string& featureType, const Value& parameters);

/// The parameters when a handle is dragged to a place: the shape then passes it, as far as its sort allows. Corners of
/// rectangles and ends of slots leave the opposite one where it is. Nothing when a size would vanish.
std::optional<Value> draggedHandle(const std::string& featureType, const Value& parameters, std::size_t handle,
                                   const Vec2& to);

/// The feature types with handles.
const std::vector<std::string>& typesWithHandles();

}  // namespace blossom::modeling
