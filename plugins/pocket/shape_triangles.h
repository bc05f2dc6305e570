#pragma once
#include "core/progress.h"
#include "geometry/shape/shape.h"
#include "kernel/path/obstacle.h"

namespace blossom::pocket {

/// mm, of the triangles of a solid that tools are compared with: more for a large one.
double chordOf(const Shape&);

Triangles trianglesOf(const Shape&, const Progress&);
Triangles trianglesOf(const Bounds&);

}  // namespace blossom::pocket
