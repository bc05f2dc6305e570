#pragma once
#include "geometry/shape/shape.h"
#include "geometry/values/box.h"

namespace blossom {

/// Axis-aligned box around a shape: exact for meshes, lines and arcs; for free-form curves and surfaces the box of their
/// poles, which may be larger. Used to fit a view and for tolerances relative to the size. O(n).
Bounds bounds(const Shape&);

}  // namespace blossom
