#include "kernel/solid/revolve.h"

#include <fmt/format.h>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <ElCLib.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax3.hxx>
#include <gp_Lin.hxx>

#include "core/error.h"
#include "core/place_text.h"
#include "core/tolerance.h"
#include "core/units.h"
#include "geometry/measure/closest_points.h"
#include "geometry/shape/compound.h"
#include "kernel/parts/crossing_warning.h"
#include "kernel/parts/finished_solid.h"
#include "kernel/parts/guarded.h"
#include "kernel/parts/placement.h"
#include "kernel/parts/profile.h"
#include "kernel/parts/shape_parts.h"
#include "kernel/parts/sound_bodies.h"

namespace blossom::modeling {

namespace {

/// How far a shape reaches to either side of the axis within its plane.
std::pair<double, double> reach(const TopoDS_Shape& shape, const gp_Ax1& axis, const gp_Dir& normal) {
  gp_Trsf toAxis;
  toAxis.SetTransformation(gp_Ax3(axis.Location(), normal, axis.Direction()));
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape.Moved(TopLoc_Location(toAxis)), box, Standard_False, Standard_False);
  double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
  box.Get(x0, y0, z0, x1, y1, z1);
  return {y0, y1};
}

/// Where the outline of a face meets the axis in its plane.
Vec3 placeOfCrossing(const TopoDS_Face& face, const gp_Ax1& axis, const Progress& progress) {
  const double size = diagonalOf(face) + gp_Lin(axis).Distance(toPoint(representatives(face).front()));
  const gp_Pnt middle = ElCLib::Value(ElCLib::Parameter(gp_Lin(axis), toPoint(representatives(face).front())), gp_Lin(axis));
  const gp_Lin line(middle, axis.Direction());
  return closestPoints(BRepTools::OuterWire(face), BRepBuilderAPI_MakeEdge(line, -size, size).Edge(), progress).first;
}

/// A turning face moves forward on one side of the axis, or of its shadow in the plane of the face where the axis leans or
/// stands off, and backward on the other: n.(a x (p - o)) = (n x a).(p - o). On one side of it, no place is swept twice.
void checkAxis(const TopoDS_Face& face, const gp_Pln& plane, const gp_Ax1& axis, const Progress& progress) {
  const gp_Dir normal = plane.Axis().Direction();
  if (normal.IsParallel(axis.Direction(), 1e-6))
    throw Error(ErrorCode::InvalidInput, "The axis stands square to the outline, so turning it sweeps no space.",
                "Choose an axis in the plane of the outline.");
  const gp_Vec direction(axis.Direction()), off(plane.Location(), axis.Location());
  const gp_Ax1 shadow(axis.Location().Translated(-off.Dot(normal) * gp_Vec(normal)),
                      gp_Dir(direction - direction.Dot(normal) * gp_Vec(normal)));
  const auto [low, high] = reach(face, shadow, normal);
  const double tolerance = Tolerance().joining;
  if (low >= -tolerance || high <= tolerance) return;
  const Vec3 place = placeOfCrossing(face, shadow, progress);
  throw Error(
      ErrorCode::InvalidInput,
      fmt::format("The outline crosses the axis near {}, so the turned shape would cut through itself.", placeText(place)),
      "Move the axis beside the outline, or cut the outline at the axis.");
}

}  // namespace

RevolveResult revolve(const TopoDS_Shape& shape, const RevolveOptions& o, const Progress& progress) {
  if (!(std::abs(o.angle) > 1e-6 && std::abs(o.angle) <= 360))
    throw Error(
        ErrorCode::InvalidParameter,
        fmt::format("The angle must lie between -360 and 360 degrees and not be 0; it is {}.", formatNumber(o.angle)));
  const gp_Ax1 axis(toPoint(o.point), toDirection(o.direction, "axis"));
  const Profile profile = profileOf(shape);
  const auto turned = [&](const TopoDS_Shape& each) {
    return BRepPrimAPI_MakeRevol(each, axis, toRadians(o.angle)).Shape();
  };
  return guarded("The outline cannot be turned about this axis.", "It may cross itself or the axis.", [&] {
    const Complaint complaint{"The turned outline gives no good solid.", "It may cross itself or the axis."};
    std::vector<TopoDS_Shape> solids, made;
    for (const TopoDS_Face& face : profile.faces) {
      progress.check();
      checkAxis(face, planeOf(face), axis, progress);
      solids.push_back(finishedSolid(turned(face), complaint));
    }
    if (!solids.empty()) made.push_back(soundBodies(solids, complaint, progress));
    std::vector<TopoDS_Shape> sheets;
    for (const TopoDS_Wire& wire : profile.wires) {
      progress.check();
      sheets.push_back(
          finishedSheet(turned(wire), {"The curve cannot be turned about this axis.", "It may cross the axis."}));
    }
    RevolveResult result;
    warnOfCrossing(sheets, "The curve crosses itself or the axis: part it there, or move the axis beside it.",
                   result.warnings, progress);
    made.insert(made.end(), sheets.begin(), sheets.end());
    result.shape = compoundOf(made);
    result.solid = !profile.faces.empty();
    return result;
  });
}

}  // namespace blossom::modeling
