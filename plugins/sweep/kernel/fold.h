#pragma once
#include <optional>

#include "core/vector.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Where x_u cross x_v reverses: the surface runs back over itself, or through a point to its other side.
struct Fold {
  double u = 0, v = 0;
  Vec3 place{0, 0, 0};     ///< mm
  bool backwards = false;  ///< x_v reverses as well: there the sections go back, and what they sweep is taken away
};

/// Whether the normal reverses between two places (u, v) on a line of constant u or v: on the way it vanishes, or jumps to
/// the opposite, or turns half round while the tangents across the line shrink to this share of what they were and come out
/// the other way, as those around the tip of a spindle do. At a sharp edge it turns, or jumps by less. O(1), 25 points.
/// @param pinch share of the longer of the two normals
std::optional<Fold> foldBetween(const Motion&, Vec2 from, Vec2 to, double pinch);

/// Whether the surface has a normal at a place where x_u cross x_v is small beside that of other places: neither tangent
/// vanishes across its own line nor reverses along it, and they are not parallel. Then the parameters alone run slowly
/// there.
bool hasNormalThere(const Motion&, const Vec2& at);

}  // namespace blossom::sweep
