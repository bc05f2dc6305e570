#pragma once
#include <optional>
#include <span>

#include "geometry/planar/region.h"

namespace blossom {

/// The place of a drawing that is one point alone: one path of one line without length. Nothing for other drawings. O(1).
std::optional<Vec2> singlePoint(std::span<const Path> drawing);
/// That drawing.
Curves pointDrawing(const Vec2&);

}  // namespace blossom
