#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom {

/// A point where the surface of a closed solid intersects itself, which BRepCheck does not detect. First as findCrossing
/// does (geometry/crossing/surface_crossing.h), which finds what is deeper than 1/1000 of the size. Then by winding numbers,
/// for sheets that hang together where they cross: where triangles meet that do not on the smooth surface, a point beside
/// them counts whose winding number is neither 0 nor 1 and that is farther from the surface than the error of the triangles
/// explains. A lemon alone, which only touches itself in its tips, encloses nothing wrongly. Nor does a spindle torus: its
/// surface runs round the lemon inside out, which is wound around 1 - 1 = 0 times and passes for a void. So whoever sweeps
/// a ring must look for sections that go back himself. Walls that lie on one another with nothing between them count,
/// too; the ends of a body that touch with nothing but a slit between them do not. O(n log n) in the triangles.
/// @throws Error Cancelled, Degenerate when the solid has no triangles.
std::optional<Vec3> selfCrossing(const TopoDS_Shape& solid, const Progress&);

}  // namespace blossom
