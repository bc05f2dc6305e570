#pragma once
#include <TopoDS_Shape.hxx>
#include <vector>

#include "core/progress.h"
#include "kernel/parts/finished_solid.h"

namespace blossom::modeling {

/// The solids that a profile swept, made one sound shape: none crosses itself (geometry/tessellate/self_crossing.h), and
/// those that overlap are united, so that no space counts twice. Solids that only touch stay apart. BRepCheck sees neither,
/// for it looks at each face alone. A Boolean operation for each pair of solids whose boxes overlap.
/// @throws Error Degenerate with the place of a crossing and the hint of the complaint, Cancelled.
TopoDS_Shape soundBodies(const std::vector<TopoDS_Shape>& solids, const Complaint&, const Progress&);

}  // namespace blossom::modeling
