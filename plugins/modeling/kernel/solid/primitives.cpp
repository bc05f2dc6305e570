#include "kernel/solid/primitives.h"

#include <fmt/format.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>

#include "core/error.h"
#include "core/tolerance.h"
#include "core/units.h"
#include "kernel/parts/finished_solid.h"
#include "kernel/parts/guarded.h"

namespace blossom::modeling {

namespace {

constexpr double smallestLength = 1e-6;

void needLength(double value, const char* what) {
  if (!(value > smallestLength))
    throw Error(ErrorCode::InvalidParameter, fmt::format("The {} must be above 0; it is {} mm.", what, formatNumber(value)));
}

/// The angle in radians. @throws Error when it is no part of a turn.
double needAngle(double degrees) {
  if (!(degrees > 1e-6 && degrees <= 360))
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The angle must be above 0 and at most 360 degrees; it is {}.", formatNumber(degrees)));
  return toRadians(degrees);
}

template <class Make>
TopoDS_Shape solidOf(const char* what, Make make) {
  const std::string message = fmt::format("The {} cannot be made with these measures.", what);
  return guarded(message, "", [&] { return finishedSolid(make(), {message, "Its measures are too small or too unlike."}); });
}

}  // namespace

TopoDS_Shape makeBox(const BoxOptions& o) {
  needLength(o.width, "width");
  needLength(o.depth, "depth");
  needLength(o.height, "height");
  const double across = o.anchor == BoxAnchor::Corner ? 0 : -0.5;
  const double up = o.anchor == BoxAnchor::Centre ? -0.5 : 0;
  gp_Ax2 frame = frameOf(o.placement);
  frame.Translate(gp_Vec(frame.XDirection()) * (across * o.width) + gp_Vec(frame.YDirection()) * (across * o.depth) +
                  gp_Vec(frame.Direction()) * (up * o.height));
  return solidOf("box", [&] { return BRepPrimAPI_MakeBox(frame, o.width, o.depth, o.height).Shape(); });
}

TopoDS_Shape makeCylinder(const CylinderOptions& o) {
  needLength(o.radius, "radius");
  needLength(o.height, "height");
  const double angle = needAngle(o.angle);
  return solidOf("cylinder",
                 [&] { return BRepPrimAPI_MakeCylinder(frameOf(o.placement), o.radius, o.height, angle).Shape(); });
}

TopoDS_Shape makeCone(const ConeOptions& o) {
  if (std::abs(o.bottomRadius - o.topRadius) <= smallestLength)
    return makeCylinder({.radius = o.bottomRadius, .height = o.height, .angle = o.angle, .placement = o.placement});
  needLength(o.height, "height");
  needLength(std::max(o.bottomRadius, o.topRadius), "larger radius");
  if (std::min(o.bottomRadius, o.topRadius) < 0)
    throw Error(ErrorCode::InvalidParameter, "A radius of the cone is below 0.", "Use 0 for a pointed end.");
  const double angle = needAngle(o.angle);
  return solidOf("cone", [&] {
    return BRepPrimAPI_MakeCone(frameOf(o.placement), o.bottomRadius, o.topRadius, o.height, angle).Shape();
  });
}

TopoDS_Shape makeSphere(const SphereOptions& o) {
  needLength(o.radius, "radius");
  const double angle = needAngle(o.angle);
  return solidOf("sphere", [&] { return BRepPrimAPI_MakeSphere(frameOf(o.placement), o.radius, angle).Shape(); });
}

TopoDS_Shape makeTorus(const TorusOptions& o) {
  needLength(o.tube, "tube radius");
  if (!(o.radius > o.tube + smallestLength))
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The torus would cut through itself: its tube of {} mm reaches the axis, which is {} mm away.",
                            formatNumber(o.tube), formatNumber(o.radius)),
                "Make the tube thinner or the radius larger.");
  const double angle = needAngle(o.angle);
  return solidOf("torus", [&] { return BRepPrimAPI_MakeTorus(frameOf(o.placement), o.radius, o.tube, angle).Shape(); });
}

}  // namespace blossom::modeling
