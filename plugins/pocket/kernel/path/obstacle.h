#pragma once
#include <array>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/toolpath.h"

namespace blossom::pocket {

using Triangles = std::vector<std::array<Vec3, 3>>;

struct ObstacleOptions {
  double above = 0;   ///< height above which the triangles are obstacles; what lies below is to be cut
  double margin = 0;  ///< mm, allowed penetration of the tool
};

struct ObstacleHit {
  Vec3 tip = Vec3::Zero();  ///< approximate position of the tool's tip at the deepest hit of the tested moves
  double depth = 0;         ///< mm, penetration of the tool's side into the obstacle, seen from above
};

/// Whether the tool would hit triangles above a height. The tool counts with its diameter at all heights above its tip, so
/// it must not come near the projection of the triangles to the plane; only moves above all triangles are exempt. O((moves +
/// triangles) log n). @throws Error Cancelled.
std::optional<ObstacleHit> obstacleHit(const Toolpath&, const Triangles&, const ObstacleOptions&,
                                       const Progress& = Progress::none());

}  // namespace blossom::pocket
