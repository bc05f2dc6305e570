#include "wire_outlines.h"

#include <TopLoc_Location.hxx>
#include <cmath>
#include <gp_Ax3.hxx>
#include <gp_Pln.hxx>

#include "core/tolerance.h"
#include "geometry/occt/occt.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/compound.h"
#include "kernel/parts/profile.h"
#include "kernel/parts/shape_parts.h"

namespace blossom::modeling {
namespace {

/// In a level plane the drawing keeps the x and y of space, so that messages name them.
gp_Trsf placeOf(const gp_Pln& plane) {
  const gp_Dir normal = plane.Axis().Direction();
  gp_Trsf place;
  if (!normal.IsParallel(gp::DZ(), Tolerance().angular))
    place.SetTransformation(gp_Ax3(plane.Location(), normal, plane.XAxis().Direction()), gp_Ax3(gp::XOY()));
  else if (std::abs(plane.Location().Z()) > Tolerance().confusion)
    place.SetTranslation(gp_Vec(0, 0, plane.Location().Z()));
  return place;
}

bool sharesPlane(const FlatOutlines& outlines, const gp_Pln& plane) {
  const gp_Pln other = gp_Pln(gp::XOY()).Transformed(outlines.place);
  return other.Axis().IsParallel(plane.Axis(), 1e-6) && other.Distance(plane.Location()) < Tolerance().confusion;
}

/// The wire as one closed path of that plane; no path when it is open or has other curves than a drawing can have.
Curves closedPath(const TopoDS_Wire& wire, const gp_Trsf& place) {
  Curves drawing = joined(planarCurves(wire.Moved(TopLoc_Location(place.Inverted()))));
  return drawing.paths.size() == 1 && drawing.paths.front().closed ? drawing : Curves{};
}

bool addTo(std::vector<FlatOutlines>& all, const TopoDS_Wire& wire) {
  const auto plane = onlyPlaneOf(wire);
  if (!plane) return false;
  for (FlatOutlines& outlines : all) {
    if (!sharesPlane(outlines, *plane)) continue;
    const Curves path = closedPath(wire, outlines.place);
    outlines.drawing.paths.insert(outlines.drawing.paths.end(), path.paths.begin(), path.paths.end());
    return !path.paths.empty();
  }
  const gp_Trsf place = placeOf(*plane);
  Curves path = closedPath(wire, place);
  if (path.paths.empty()) return false;
  all.push_back({std::move(path), place});
  return true;
}

}  // namespace

WireOutlines wireOutlines(const TopoDS_Shape& shape) {
  WireOutlines found;
  std::vector<TopoDS_Shape> others = partsOf(shape, TopAbs_FACE);
  for (const TopoDS_Wire& wire : looseWires(shape))
    if (!addTo(found.outlines, wire)) others.push_back(wire);
  if (!others.empty()) found.others = compoundOf(others);
  return found;
}

}  // namespace blossom::modeling
