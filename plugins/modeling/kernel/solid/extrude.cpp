#include "kernel/solid/extrude.h"

#include <fmt/format.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>

#include "core/error.h"
#include "core/units.h"
#include "geometry/shape/compound.h"
#include "kernel/parts/finished_solid.h"
#include "kernel/parts/guarded.h"
#include "kernel/parts/placement.h"
#include "kernel/parts/profile.h"
#include "kernel/parts/shape_parts.h"
#include "kernel/parts/sound_bodies.h"
#include "kernel/solid/taper.h"

namespace blossom::modeling {

namespace {

constexpr double smallestHeight = 1e-6;

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Vec& by) {
  gp_Trsf trsf;
  trsf.SetTranslation(by);
  return shape.Moved(TopLoc_Location(trsf));
}

const char* const mixedMeasures = "The extrusion gives no good solid.";

/// The one direction in which a profile goes.
gp_Dir directionOf(const ExtrudeOptions& o, const gp_Pln& plane) {
  const gp_Dir normal = plane.Axis().Direction();
  if (o.direction.isZero()) return normal;
  const gp_Dir given = toDirection(o.direction, "direction");
  if (std::abs(given.Dot(normal)) < 1e-6)
    throw Error(ErrorCode::InvalidParameter, "The direction lies in the plane of the outline, so it sweeps no space.",
                "Give a direction that leaves the plane of the outline.");
  return given;
}

TopoDS_Shape taperedBothWays(const TopoDS_Face& face, const gp_Pln& plane, const ExtrudeOptions& o,
                             const Progress& progress) {
  if (!o.direction.isZero() && !directionOf(o, plane).IsParallel(plane.Axis().Direction(), 1e-9))
    throw Error(ErrorCode::InvalidParameter, "A taper and a slanted direction cannot be combined.",
                "Set the taper to 0 or the direction to 0,0,0.");
  if (std::abs(o.back) < smallestHeight) return taperedSolid(face, plane, o.height, o.taper, progress);
  const TopoDS_Shape there = taperedSolid(face, plane, o.height, o.taper, progress),
                     back = taperedSolid(face, plane, -o.back, o.taper, progress);
  return BRepAlgoAPI_Fuse(there, back).Shape();
}

TopoDS_Shape solidOver(const TopoDS_Face& face, const ExtrudeOptions& o, const Progress& progress) {
  const gp_Pln plane = planeOf(face);
  const Complaint complaint{mixedMeasures, "The outline may cross itself, or its parts may overlap."};
  if (std::abs(o.taper) > 1e-9) return finishedSolid(taperedBothWays(face, plane, o, progress), complaint);
  const gp_Vec along(directionOf(o, plane));
  return finishedSolid(BRepPrimAPI_MakePrism(moved(face, along * -o.back), along * (o.height + o.back)).Shape(), complaint);
}

TopoDS_Shape sheetOver(const TopoDS_Wire& wire, const ExtrudeOptions& o) {
  if (std::abs(o.taper) > 1e-9)
    throw Error(ErrorCode::InvalidParameter, "Only closed outlines that are filled can be extruded with a taper.",
                "Close the outline, or set the taper to 0.");
  const gp_Vec along(directionOf(o, planeOf(wire)));
  return finishedSheet(BRepPrimAPI_MakePrism(moved(wire, along * -o.back), along * (o.height + o.back)).Shape(),
                       {"The curve cannot be extruded.", "It may cross itself."});
}

void check(const ExtrudeOptions& o) {
  if (std::abs(o.height + o.back) < smallestHeight)
    throw Error(ErrorCode::InvalidParameter, "The extrusion has no height.", "Give a height other than 0.");
  if (o.back < 0 || (o.height < 0 && o.back > 0))
    throw Error(ErrorCode::InvalidParameter, "The two ways of the extrusion go against each other.",
                "Use lengths of 0 or more for both, or one negative height alone.");
  if (!(std::abs(o.taper) < 89))
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The taper must stay within -89 and 89 degrees; it is {}.", formatNumber(o.taper)));
  if (std::abs(o.taper) > 1e-9 && std::abs(o.height) < smallestHeight)
    throw Error(ErrorCode::InvalidParameter, "A tapered extrusion needs a height other than 0.");
}

}  // namespace

Vec3 directionOf(const TopoDS_Shape& shape, const ExtrudeOptions& o) {
  const Profile profile = profileOf(shape);
  return toVec(
      directionOf(o, profile.faces.empty() ? planeOf(profile.wires.front()) : planeOf(profile.faces.front())).XYZ());
}

ExtrudeResult extrude(const TopoDS_Shape& shape, const ExtrudeOptions& o, const Progress& progress) {
  check(o);
  const Profile profile = profileOf(shape);
  return guarded("The outline cannot be extruded.", "It may cross itself, or be too small.", [&] {
    std::vector<TopoDS_Shape> solids, made;
    const auto next = [&] {
      progress.report(static_cast<double>(solids.size() + made.size()) /
                          static_cast<double>(profile.faces.size() + profile.wires.size()),
                      "Extruding");
    };
    for (const TopoDS_Face& face : profile.faces) {
      next();
      solids.push_back(solidOver(face, o, progress));
    }
    // Straight sides over an outline that does not cross itself cannot meet.
    if (std::abs(o.taper) > 1e-9 && !solids.empty()) solids = {soundBodies(solids, tooSteep(o.taper), progress)};
    if (!solids.empty()) made.push_back(compoundOf(solids));
    for (const TopoDS_Wire& wire : profile.wires) {
      next();
      made.push_back(sheetOver(wire, o));
    }
    return ExtrudeResult{compoundOf(made), !profile.faces.empty()};
  });
}

}  // namespace blossom::modeling
