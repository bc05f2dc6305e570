#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom {

/// A point where two solids hold the same space; nothing when they are apart or only touch. Surfaces that pass through one
/// another are found as findCrossing does (geometry/crossing/surface_crossing.h); flat faces that cover one another and look
/// the same way have the same space under them; then a place just under the skin of one is looked for inside the other, for
/// solids that share walls, lie within one another or are the same. What they have in common is found where it is thicker
/// than about 1/1000 of their common size, between flat faces about 1/20000; strips of flat faces that are narrower than
/// about 1/5000 do not count. O(n log n) in the triangles, and nothing for solids whose boxes are apart.
/// @throws Error Cancelled, Degenerate when one has no triangles.
std::optional<Vec3> overlapOf(const TopoDS_Shape&, const TopoDS_Shape&, const Progress& = Progress::none());

}  // namespace blossom
