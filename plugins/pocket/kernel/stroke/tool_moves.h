#pragma once
#include <optional>

#include "geometry/shape/toolpath.h"
#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

/// The move projected to the XY plane.
Stroke wayOf(const Vec3& from, const ToolMove&);

/// The part of a move below a height.
struct MoveBelow {
  Vec3 from, to;
  Stroke way;
};
std::optional<MoveBelow> below(const Vec3& from, const ToolMove&, double top);

}  // namespace blossom::pocket
