#include "kernel/parts/sound_bodies.h"

#include <fmt/format.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <TopTools_ListOfShape.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/place_text.h"
#include "geometry/crossing/self_crossing.h"
#include "geometry/numeric/union_find.h"
#include "geometry/occt/occt_progress.h"
#include "geometry/shape/compound.h"
#include "kernel/parts/boolean.h"
#include "kernel/parts/shape_parts.h"

namespace blossom::modeling {
namespace {

void refuseCrossing(const TopoDS_Shape& solid, const Complaint& complaint, const Progress& progress) {
  const auto place = selfCrossing(solid, progress);
  if (!place) return;
  throw Error(ErrorCode::Degenerate,
              fmt::format("{} It would cut through itself near {}.", complaint.message, placeText(*place)), complaint.hint);
}

Bnd_Box boxAround(const TopoDS_Shape& solid) {
  Bnd_Box box;
  BRepBndLib::Add(solid, box, Standard_False);
  return box;
}

/// Whether two solids share more space than rounding makes of a common wall.
bool overlap(const TopoDS_Shape& a, const TopoDS_Shape& b, const Progress& progress) {
  BRepAlgoAPI_Common common;
  TopTools_ListOfShape first, second;
  first.Append(a);
  second.Append(b);
  common.SetArguments(first);
  common.SetTools(second);
  common.SetNonDestructive(Standard_True);
  const Handle(OcctProgress) watcher = new OcctProgress(progress, "Looking for overlaps");
  common.Build(watcher->Start());
  progress.check();
  if (common.HasErrors() || common.Shape().IsNull()) return false;
  const double smaller = std::min(std::abs(volumeOf(a)), std::abs(volumeOf(b)));
  return std::abs(volumeOf(common.Shape())) > 1e-9 * smaller;
}

/// The numbers of solids that hang together by overlaps, in the order of the first of each group.
std::map<std::size_t, std::vector<std::size_t>> overlappingGroups(const std::vector<TopoDS_Shape>& solids,
                                                                  const Progress& progress) {
  std::vector<Bnd_Box> boxes;
  boxes.reserve(solids.size());
  for (const TopoDS_Shape& solid : solids) boxes.push_back(boxAround(solid));
  UnionFind sets(solids.size());
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (std::size_t k = i + 1; k < solids.size(); ++k)
      if (!boxes[i].IsOut(boxes[k]) && sets.find(i) != sets.find(k) && overlap(solids[i], solids[k], progress))
        sets.unite(i, k);
  std::map<std::size_t, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < solids.size(); ++i) groups[sets.find(i)].push_back(i);
  return groups;
}

}  // namespace

TopoDS_Shape soundBodies(const std::vector<TopoDS_Shape>& solids, const Complaint& complaint, const Progress& progress) {
  for (const TopoDS_Shape& solid : solids) refuseCrossing(solid, complaint, progress);
  std::vector<TopoDS_Shape> bodies;
  for (const auto& [first, members] : overlappingGroups(solids, progress)) {
    std::vector<TopoDS_Shape> group;
    group.reserve(members.size());
    for (const std::size_t each : members) group.push_back(solids[each]);
    bodies.push_back(group.size() == 1 ? group.front() : combine(group, {}, progress).shape);
  }
  return compoundOf(bodies);
}

}  // namespace blossom::modeling
