#pragma once
#include <array>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/toolpath.h"

namespace blossom::pocket {

using Triangles = std::vector<std::array<Vec3, 3>>;

struct ObstacleOptions {
  double above = 0;   ///< height above which the triangles are obstacles: what lies below is what the path is to cut
  double margin = 0;  ///< mm that the tool may reach into them
};

struct ObstacleHit {
  Vec3 tip = Vec3::Zero();  ///< of the tool, about where it hits most of those moves looked at
  double depth = 0;         ///< mm that its side reaches into the obstacle, seen from above
};

/// Whether the tool would hit what stands above a height. The tool is as wide as its diameter at all heights above its tip,
/// so what it may not come near to is the shadow of the triangles on the plane; only moves above all triangles are free of
/// it. O((moves + triangles) log n). @throws Error Cancelled.
std::optional<ObstacleHit> obstacleHit(const Toolpath&, const Triangles&, const ObstacleOptions&,
                                       const Progress& = Progress::none());

}  // namespace blossom::pocket
