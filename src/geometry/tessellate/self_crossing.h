#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom {

/// A point where the surface of a closed solid intersects itself, which BRepCheck does not detect. Intersections are
/// searched exactly among the triangles of the surface, at chords of 1/1000, 1/10,000 and 1/50,000 of the solid's size.
/// Triangles of a thin wall may intersect where the wall does not: an intersection counts only when a point beside it,
/// farther from the true surface than its triangles are, has a winding number other than 0 and 1, which the error of the
/// triangles cannot explain. Overlaps below 1/25,000 of the size are therefore not found. O(n log n) in the triangles, plus
/// O(n) per intersection.
/// @throws Error Cancelled, Degenerate when the solid has no triangles.
std::optional<Vec3> selfCrossing(const TopoDS_Shape& solid, const Progress&);

}  // namespace blossom
