#pragma once
#include "core/progress.h"
#include "geometry/shape/shape.h"
#include "kernel/path/obstacle.h"

namespace blossom::pocket {

/// mm, of the triangles of a solid that tools are compared with.
inline constexpr double obstacleChord = 0.005;

Triangles trianglesOf(const Shape&, const Progress&);
Triangles trianglesOf(const Bounds&);

}  // namespace blossom::pocket
