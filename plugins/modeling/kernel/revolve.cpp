#include "kernel/revolve.h"

#include <fmt/format.h>

#include <BRepBndLib.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <Bnd_Box.hxx>
#include <TopLoc_Location.hxx>
#include <gp_Ax3.hxx>
#include <gp_Lin.hxx>

#include "core/error.h"
#include "core/tolerance.h"
#include "core/units.h"
#include "kernel/finished_solid.h"
#include "kernel/guarded.h"
#include "kernel/placement.h"
#include "kernel/profile.h"
#include "kernel/shape_parts.h"

namespace blossom::modeling {

namespace {

[[noreturn]] void throwCrosses() {
  throw Error(ErrorCode::InvalidInput, "The outline crosses the axis, so the turned shape would cut through itself.",
              "Move the axis beside the outline, or cut the outline at the axis.");
}

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

void checkAxis(const TopoDS_Shape& shape, const gp_Pln& plane, const gp_Ax1& axis) {
  const gp_Dir normal = plane.Axis().Direction();
  if (normal.IsParallel(axis.Direction(), 1e-6))
    throw Error(ErrorCode::InvalidInput, "The axis stands square to the outline, so turning it sweeps no space.",
                "Choose an axis in the plane of the outline.");
  const bool inPlane = normal.IsNormal(axis.Direction(), 1e-9) && plane.Distance(axis.Location()) < 1e-6;
  if (!inPlane) return;
  const auto [low, high] = reach(shape, axis, normal);
  const double tolerance = Tolerance().joining;
  if (low < -tolerance && high > tolerance) throwCrosses();
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
    std::vector<TopoDS_Shape> made;
    made.reserve(profile.faces.size() + profile.wires.size());
    for (const TopoDS_Face& face : profile.faces) {
      progress.check();
      checkAxis(face, planeOf(face), axis);
      made.push_back(
          finishedSolid(turned(face), {"The turned outline gives no good solid.", "It may cross itself or the axis."}));
    }
    for (const TopoDS_Wire& wire : profile.wires) {
      progress.check();
      made.push_back(finishedSheet(turned(wire), {"The curve cannot be turned about this axis.", "It may cross the axis."}));
    }
    return RevolveResult{together(made), !profile.faces.empty()};
  });
}

}  // namespace blossom::modeling
