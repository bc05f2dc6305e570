#include "kernel/solid/taper.h"

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_DraftAngle.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <limits>
#include <numbers>
#include <optional>

#include "core/error.h"
#include "core/place_text.h"
#include "core/units.h"
#include "geometry/crossing/self_crossing.h"
#include "kernel/parts/guarded.h"
#include "kernel/parts/largest_size.h"
#include "kernel/parts/placement.h"
#include "kernel/parts/shape_parts.h"

namespace blossom::modeling {

namespace {

constexpr double negligible = 1e-6;  // mm

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
  for (const TopoDS_Shape& each : subShapesOf(shape, TopAbs_FACE)) {
    const BRepAdaptor_Surface surface(TopoDS::Face(each));
    if (surface.GetType() != GeomAbs_Cone) continue;
    const gp_Cone cone = surface.Cone();
    const auto radiusAt = [&](double v) { return cone.RefRadius() + v * std::sin(cone.SemiAngle()); };
    const double first = radiusAt(surface.FirstVParameter()), last = radiusAt(surface.LastVParameter());
    if (std::min(first, last) < -negligible && std::max(first, last) > negligible) return true;
  }
  return false;
}

/// Null when OCCT makes no good solid of it.
TopoDS_Shape leaning(const TopoDS_Shape& prism, const gp_Pln& base, double height, double taper) {
  BRepOffsetAPI_DraftAngle draft(prism);
  const gp_Dir up = height > 0 ? base.Axis().Direction() : base.Axis().Direction().Reversed();
  for (const TopoDS_Shape& each : subShapesOf(prism, TopAbs_FACE)) {
    const TopoDS_Face face = TopoDS::Face(each);
    if (!isSide(face, base, height)) continue;
    draft.Add(face, up, toRadians(taper), base);
    if (!draft.AddDone()) throwFreeForm();
  }
  draft.Build();
  if (!draft.IsDone() || !isGoodSolid(draft.Shape()) || passesAnApex(draft.Shape())) return {};
  return draft.Shape();
}

TopoDS_Shape prismOf(const TopoDS_Face& face, const gp_Pln& plane, double height) {
  return finishedSolid(BRepPrimAPI_MakePrism(face, gp_Vec(plane.Axis().Direction()) * height).Shape(),
                       {"The extrusion gives no good solid.", ""});
}

/// The edges at the far end of a solid over a plane.
std::vector<TopoDS_Shape> farEdges(const TopoDS_Shape& solid, const gp_Pln& base, double height) {
  std::vector<TopoDS_Shape> edges;
  for (const TopoDS_Shape& each : subShapesOf(solid, TopAbs_EDGE)) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(each));
    const auto isFar = [&](double t) {
      const gp_Vec up(base.Location(), curve.Value(t));
      return std::abs(up.Dot(gp_Vec(base.Axis().Direction())) - height) < 1e-6 * std::abs(height);
    };
    if (isFar(curve.FirstParameter()) && isFar(curve.LastParameter())) edges.push_back(each);
  }
  return edges;
}

bool shareAVertex(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  for (const TopoDS_Shape& p : subShapesOf(a, TopAbs_VERTEX))
    for (const TopoDS_Shape& q : subShapesOf(b, TopAbs_VERTEX))
      if (p.IsSame(q)) return true;
  return false;
}

/// The narrowest place between edges: the middle of the shortest, or where two that are no neighbours come nearest.
std::optional<gp_Pnt> narrowestPlace(const std::vector<TopoDS_Shape>& edges, const Progress& progress) {
  constexpr std::size_t most = 100;  // all pairs are tested
  if (edges.size() > most) return {};
  std::optional<gp_Pnt> place;
  double narrowest = std::numeric_limits<double>::infinity();
  const auto offer = [&](double width, const gp_Pnt& p) {
    if (width < narrowest) narrowest = width, place = p;
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    progress.check();
    const BRepAdaptor_Curve curve(TopoDS::Edge(edges[i]));
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    offer(GCPnts_AbscissaPoint::Length(curve), curve.Value((first + last) / 2));
    for (std::size_t k = 0; k < i; ++k) {
      if (shareAVertex(edges[i], edges[k])) continue;
      const BRepExtrema_DistShapeShape between(edges[i], edges[k]);
      if (!between.IsDone() || between.NbSolution() == 0) continue;
      const gp_Pnt p = between.PointOnShape1(1), q = between.PointOnShape2(1);
      offer(between.Value(), gp_Pnt((p.XYZ() + q.XYZ()) / 2));
    }
  }
  return place;
}

/// Refuses a taper with the height at which its sides meet, and where.
[[noreturn]] void throwSidesMeet(const TopoDS_Face& face, const gp_Pln& plane, double height, double taper,
                                 const Progress& progress) {
  const double sign = height < 0 ? -1 : 1;
  TopoDS_Shape last;
  const auto stands = [&](double size) {
    const TopoDS_Shape solid = leaning(prismOf(face, plane, sign * size), plane, sign * size, taper);
    if (solid.IsNull() || selfCrossing(solid, progress)) return false;
    last = solid;
    return true;
  };
  const Complaint complaint = tooSteep(taper);
  const auto largest = largestSize(std::abs(height), stands, progress);
  const auto place = largest ? narrowestPlace(farEdges(last, plane, sign * *largest), progress) : std::nullopt;
  if (!place) throw Error(ErrorCode::Degenerate, complaint.message, complaint.hint);
  throw Error(ErrorCode::Degenerate,
              fmt::format("{} They meet at a height of about {} mm, near {}.", complaint.message, roundedDown(*largest),
                          placeText(toVec(place->XYZ()))),
              complaint.hint);
}

/// The circle around a disc without holes, which a drawing may make of several arcs.
std::optional<gp_Circ> circleAround(const TopoDS_Face& face) {
  if (subShapesOf(face, TopAbs_WIRE).size() != 1) return {};
  std::optional<gp_Circ> around;
  double turned = 0;
  for (const TopoDS_Shape& each : subShapesOf(face, TopAbs_EDGE)) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(each));
    if (curve.GetType() != GeomAbs_Circle) return {};
    const gp_Circ circle = curve.Circle();
    if (around && (around->Location().Distance(circle.Location()) > negligible ||
                   std::abs(around->Radius() - circle.Radius()) > negligible))
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
  if (end < -negligible) {
    const gp_Pnt tip = base.Location().Translated(gp_Vec(up) * (base.Radius() / slope));
    throw Error(ErrorCode::Degenerate,
                fmt::format("{} They meet at a height of {:.9g} mm, in {}.", tooSteep(taper).message, base.Radius() / slope,
                            placeText(toVec(tip.XYZ()))),
                tooSteep(taper).hint);
  }
  const gp_Ax2 axes(base.Location(), up, base.XAxis().Direction());
  return BRepPrimAPI_MakeCone(axes, base.Radius(), end > negligible ? end : 0, std::abs(height)).Shape();
}

}  // namespace

Complaint tooSteep(double taper) {
  return {fmt::format("With a taper of {} degrees the sides meet before the full height is reached.", formatNumber(taper)),
          "Use a smaller taper or height."};
}

TopoDS_Shape taperedSolid(const TopoDS_Face& face, const gp_Pln& plane, double height, double taper,
                          const Progress& progress) {
  const bool leansAtAll = std::abs(height * std::tan(toRadians(taper))) > negligible;
  if (const auto circle = circleAround(face); circle && leansAtAll)
    return cone(*circle, plane.Axis().Direction(), height, taper);
  return guarded("The sides of the extrusion cannot be tapered.", "Use a smaller taper.", [&] {
    const TopoDS_Shape solid = leaning(prismOf(face, plane, height), plane, height, taper);
    if (solid.IsNull()) throwSidesMeet(face, plane, height, taper, progress);
    return solid;
  });
}

}  // namespace blossom::modeling
