#include "kernel/extrude.h"

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_DraftAngle.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <numbers>
#include <optional>

#include "core/error.h"
#include "core/units.h"
#include "kernel/finished_solid.h"
#include "kernel/guarded.h"
#include "kernel/placement.h"
#include "kernel/profile.h"
#include "kernel/shape_parts.h"
#include "kernel/sound_bodies.h"

namespace blossom::modeling {

namespace {

constexpr double smallest = 1e-6;

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Vec& by) {
  gp_Trsf trsf;
  trsf.SetTranslation(by);
  return shape.Moved(TopLoc_Location(trsf));
}

const char* const mixedMeasures = "The extrusion gives no good solid.";

Complaint tooSteep(double taper) {
  return {fmt::format("With a taper of {} degrees the sides meet before the full height is reached.", formatNumber(taper)),
          "Use a smaller taper or height."};
}

[[noreturn]] void throwTaper(double taper) {
  throw Error(ErrorCode::Degenerate, tooSteep(taper).message, tooSteep(taper).hint);
}

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

/// A flat side of a prism has its centre between the ends; the ends are what must not lean.
bool isSide(const TopoDS_Face& face, const gp_Pln& base, double height) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(face, properties);
  const gp_Vec up(base.Axis().Direction());
  const double z = gp_Vec(base.Location(), properties.CentreOfMass()).Dot(up) / height;
  return z > 1e-6 && z < 1 - 1e-6;
}

[[noreturn]] void throwFreeForm() {
  throw Error(ErrorCode::InvalidInput, "A taper needs outlines of lines and arcs; this one has free-form curves.",
              "Extrude without a taper, or loft between two outlines.");
}

/// A circle that shrinks to a point goes on beyond it as a second cone, tip to tip with the first.
bool passesAnApex(const TopoDS_Shape& shape) {
  for (const TopoDS_Shape& each : partsOf(shape, TopAbs_FACE)) {
    const BRepAdaptor_Surface surface(TopoDS::Face(each));
    if (surface.GetType() != GeomAbs_Cone) continue;
    const gp_Cone cone = surface.Cone();
    const auto radiusAt = [&](double v) { return cone.RefRadius() + v * std::sin(cone.SemiAngle()); };
    const double first = radiusAt(surface.FirstVParameter()), last = radiusAt(surface.LastVParameter());
    if (std::min(first, last) < -smallest && std::max(first, last) > smallest) return true;
  }
  return false;
}

TopoDS_Shape leaning(const TopoDS_Shape& prism, const gp_Pln& base, double height, double taper) {
  BRepOffsetAPI_DraftAngle draft(prism);
  const gp_Dir up = height > 0 ? base.Axis().Direction() : base.Axis().Direction().Reversed();
  for (const TopoDS_Shape& each : partsOf(prism, TopAbs_FACE)) {
    const TopoDS_Face face = TopoDS::Face(each);
    if (!isSide(face, base, height)) continue;
    draft.Add(face, up, toRadians(taper), base);
    if (!draft.AddDone()) throwFreeForm();
  }
  draft.Build();
  if (!draft.IsDone() || !isGoodSolid(draft.Shape()) || passesAnApex(draft.Shape())) throwTaper(taper);
  return draft.Shape();
}

/// The circle around a disc without holes, which a drawing may make of several arcs.
std::optional<gp_Circ> circleAround(const TopoDS_Face& face) {
  if (partsOf(face, TopAbs_WIRE).size() != 1) return {};
  std::optional<gp_Circ> around;
  double turned = 0;
  for (const TopoDS_Shape& each : partsOf(face, TopAbs_EDGE)) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(each));
    if (curve.GetType() != GeomAbs_Circle) return {};
    const gp_Circ circle = curve.Circle();
    if (around && (around->Location().Distance(circle.Location()) > smallest ||
                   std::abs(around->Radius() - circle.Radius()) > smallest))
      return {};
    around = circle;
    turned += std::abs(curve.LastParameter() - curve.FirstParameter());
  }
  return around && std::abs(turned - 2 * std::numbers::pi) < 1e-6 ? around : std::nullopt;
}

/// Near its tip OCCT loses the end of a cone that it leans from a cylinder, so discs get theirs at once.
TopoDS_Shape cone(const gp_Circ& base, const gp_Dir& normal, double height, double taper) {
  const gp_Dir up = height > 0 ? normal : normal.Reversed();
  const double slope = std::tan(toRadians(taper)), end = base.Radius() - std::abs(height) * slope;
  if (end < -smallest) {
    const gp_Pnt tip = base.Location().Translated(gp_Vec(up) * (base.Radius() / slope));
    const auto rounded = [](double v) { return std::round(v * 1e6) / 1e6 + 0.0; };
    throw Error(ErrorCode::Degenerate,
                fmt::format("{} They meet at a height of {:.9g} mm, in ({:.6g}, {:.6g}, {:.6g}).", tooSteep(taper).message,
                            base.Radius() / slope, rounded(tip.X()), rounded(tip.Y()), rounded(tip.Z())),
                tooSteep(taper).hint);
  }
  const gp_Ax2 axes(base.Location(), up, base.XAxis().Direction());
  return BRepPrimAPI_MakeCone(axes, base.Radius(), end > smallest ? end : 0, std::abs(height)).Shape();
}

/// From the plane of the face by `height` along its normal, leaning.
TopoDS_Shape tapered(const TopoDS_Face& face, const gp_Pln& plane, double height, double taper) {
  const bool leansAtAll = std::abs(height * std::tan(toRadians(taper))) > smallest;
  if (const auto circle = circleAround(face); circle && leansAtAll)
    return cone(*circle, plane.Axis().Direction(), height, taper);
  const TopoDS_Shape prism = BRepPrimAPI_MakePrism(face, gp_Vec(plane.Axis().Direction()) * height).Shape();
  return guarded("The sides of the extrusion cannot be tapered.", "Use a smaller taper.", [&] {
    return leaning(finishedSolid(prism, {mixedMeasures, ""}), plane, height, taper);
  });
}

TopoDS_Shape taperedBothWays(const TopoDS_Face& face, const gp_Pln& plane, const ExtrudeOptions& o) {
  if (!o.direction.isZero() && !directionOf(o, plane).IsParallel(plane.Axis().Direction(), 1e-9))
    throw Error(ErrorCode::InvalidParameter, "A taper and a slanted direction cannot be combined.",
                "Set the taper to 0 or the direction to 0,0,0.");
  if (std::abs(o.back) < smallest) return tapered(face, plane, o.height, o.taper);
  const TopoDS_Shape there = tapered(face, plane, o.height, o.taper), back = tapered(face, plane, -o.back, o.taper);
  return BRepAlgoAPI_Fuse(there, back).Shape();
}

TopoDS_Shape solidOver(const TopoDS_Face& face, const ExtrudeOptions& o) {
  const gp_Pln plane = planeOf(face);
  const Complaint complaint{mixedMeasures, "The outline may cross itself, or its parts may overlap."};
  if (std::abs(o.taper) > 1e-9) return finishedSolid(taperedBothWays(face, plane, o), complaint);
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
  if (std::abs(o.height + o.back) < smallest)
    throw Error(ErrorCode::InvalidParameter, "The extrusion has no height.", "Give a height other than 0.");
  if (o.back < 0 || (o.height < 0 && o.back > 0))
    throw Error(ErrorCode::InvalidParameter, "The two ways of the extrusion go against each other.",
                "Use lengths of 0 or more for both, or one negative height alone.");
  if (!(std::abs(o.taper) < 89))
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The taper must stay within -89 and 89 degrees; it is {}.", formatNumber(o.taper)));
  if (std::abs(o.taper) > 1e-9 && std::abs(o.height) < smallest)
    throw Error(ErrorCode::InvalidParameter, "A tapered extrusion needs a height other than 0.");
}

}  // namespace

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
      solids.push_back(solidOver(face, o));
    }
    // Straight sides over an outline that does not cross itself cannot meet.
    if (std::abs(o.taper) > 1e-9 && !solids.empty()) solids = {soundBodies(solids, tooSteep(o.taper), progress)};
    if (!solids.empty()) made.push_back(together(solids));
    for (const TopoDS_Wire& wire : profile.wires) {
      next();
      made.push_back(sheetOver(wire, o));
    }
    return ExtrudeResult{together(made), !profile.faces.empty()};
  });
}

}  // namespace blossom::modeling
