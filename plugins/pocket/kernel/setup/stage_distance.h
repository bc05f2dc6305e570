#pragma once
#include <array>

#include "core/vector.h"
#include "geometry/numeric/boxes.h"
#include "kernel/setup/tool_stages.h"

namespace blossom::pocket {

/// mm between a stage of a tool, whose tip is at the origin and whose axis is z, and a point; 0 inside.
double distanceTo(const ToolStage&, const Vec3&);

/// The same of a triangle, within 1e-9 of its size. Both are convex: the nearest place is inside the triangle only where its
/// plane supports the stage, and along its sides the distance has one minimum.
double distanceTo(const ToolStage&, const std::array<Vec3, 3>&);

/// At most the distance to anything in the box.
double distanceAtLeast(const ToolStage&, const Eigen::AlignedBox3d&);

}  // namespace blossom::pocket
