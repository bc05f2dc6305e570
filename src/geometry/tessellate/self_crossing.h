#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom {

/// A place where the surface of a closed solid cuts through itself, which BRepCheck does not see. Crossings are looked for
/// in the triangles of the surface, exactly, at distances to the surface of 1/1000 of the solid's size, 1/10,000 and
/// 1/50,000. Triangles of a thin wall may cross where the wall does not: a crossing counts only where a point beside it,
/// farther from the true surface than its triangles are, has a winding number other than 0 and 1, which no error of the
/// triangles explains. What overlaps less than 1/25,000 of the size is thus not found. O(n log n) in the triangles, and O(n)
/// for each crossing.
/// @throws Error Cancelled, Degenerate when the solid has no triangles.
std::optional<Vec3> selfCrossing(const TopoDS_Shape& solid, const Progress&);

}  // namespace blossom
