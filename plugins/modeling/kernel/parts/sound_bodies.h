#pragma once
#include <TopoDS_Shape.hxx>
#include <vector>

#include "core/progress.h"
#include "kernel/parts/finished_solid.h"

namespace blossom::modeling {

/// One valid shape of the solids that were swept from a profile: none intersects itself
/// (geometry/crossing/self_crossing.h), and overlapping ones are united, so that no space counts twice. Solids that only
/// touch remain separate. BRepCheck detects neither, because it checks each face alone. Takes a Boolean operation per pair
/// of solids with overlapping boxes.
/// @throws Error Degenerate with the place of an intersection and the hint of the complaint, Cancelled.
TopoDS_Shape soundBodies(const std::vector<TopoDS_Shape>& solids, const Complaint&, const Progress&);

}  // namespace blossom::modeling
