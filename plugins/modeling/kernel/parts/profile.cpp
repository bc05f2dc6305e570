#include "kernel/parts/profile.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepLib_FindSurface.hxx>
#include <BRep_Tool.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <ShapeAnalysis_FreeBounds.hxx>
#include <ShapeExtend_WireData.hxx>
#include <ShapeFix_Wire.hxx>
#include <TopExp.hxx>
#include <TopTools_HSequenceOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Lin.hxx>

#include "core/error.h"
#include "core/tolerance.h"
#include "kernel/parts/shape_parts.h"

namespace blossom::modeling {

namespace {

/// Edges of files often meet in two vertices at one place; a wire needs a common one.
TopoDS_Wire withCommonVertices(const TopoDS_Wire& wire) {
  ShapeFix_Wire fix;
  fix.Load(wire);
  const Handle(ShapeExtend_WireData) edges = fix.WireData();
  const gp_Pnt start = BRep_Tool::Pnt(TopExp::FirstVertex(edges->Edge(1), Standard_True));
  const gp_Pnt end = BRep_Tool::Pnt(TopExp::LastVertex(edges->Edge(edges->NbEdges()), Standard_True));
  fix.ClosedWireMode() = start.Distance(end) <= Tolerance().joining;
  fix.FixConnected(Tolerance().joining);
  TopoDS_Wire connected = fix.WireAPIMake();
  if (connected.IsNull()) return wire;
  connected.Closed(BRep_Tool::IsClosed(connected));
  return connected;
}

std::vector<TopoDS_Wire> joinedEdges(const std::vector<TopoDS_Shape>& edges) {
  Handle(TopTools_HSequenceOfShape) sequence = new TopTools_HSequenceOfShape;
  for (const TopoDS_Shape& edge : edges) sequence->Append(edge);
  Handle(TopTools_HSequenceOfShape) wires;
  ShapeAnalysis_FreeBounds::ConnectEdgesToWires(sequence, Tolerance().joining, Standard_False, wires);
  std::vector<TopoDS_Wire> joined;
  joined.reserve(static_cast<std::size_t>(wires->Length()));
  for (const TopoDS_Shape& wire : *wires) joined.push_back(withCommonVertices(TopoDS::Wire(wire)));
  return joined;
}

/// A line has many planes: the one whose normal is nearest to z.
gp_Pln planeThrough(const gp_Lin& line) {
  const gp_Dir along = line.Direction();
  const gp_Dir side = along.IsParallel(gp::DZ(), 1e-9) ? gp::DX() : gp::DZ().Crossed(along);
  return {line.Location(), along.Crossed(side)};
}

/// The direction of the only line in a wire of collinear edges; false when it turns.
bool isStraight(const TopoDS_Wire& wire, gp_Lin& line) {
  bool first = true;
  for (const TopoDS_Shape& each : subShapesOf(wire, TopAbs_EDGE)) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(each));
    if (curve.GetType() != GeomAbs_Line) return false;
    if (first) line = curve.Line();
    if (!curve.Line().Direction().IsParallel(line.Direction(), 1e-9)) return false;
    first = false;
  }
  return !first;
}

}  // namespace

std::vector<TopoDS_Wire> looseWires(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Wire> wires;
  std::vector<TopoDS_Shape> open, edges = looseParts(shape, TopAbs_EDGE, TopAbs_WIRE);
  for (const TopoDS_Shape& wire : looseParts(shape, TopAbs_WIRE, TopAbs_FACE))
    if (BRep_Tool::IsClosed(wire))
      wires.push_back(TopoDS::Wire(wire));
    else
      open.push_back(wire);
  if (open.size() == 1 && edges.empty()) {
    wires.push_back(TopoDS::Wire(open.front()));
    return wires;
  }
  for (const TopoDS_Shape& wire : open)
    for (const TopoDS_Shape& edge : looseParts(wire, TopAbs_EDGE, TopAbs_FACE)) edges.push_back(edge);
  if (edges.empty()) return wires;
  for (const TopoDS_Wire& wire : joinedEdges(edges)) wires.push_back(wire);
  return wires;
}

Profile profileOf(const TopoDS_Shape& shape) {
  Profile profile;
  if (!subShapesOf(shape, TopAbs_SOLID).empty())
    throw Error(ErrorCode::InvalidInput, "A solid is not an outline that could be swept.",
                "Choose one of its flat faces, or give a region.");
  for (const TopoDS_Shape& face : subShapesOf(shape, TopAbs_FACE)) profile.faces.push_back(TopoDS::Face(face));
  profile.wires = looseWires(shape);
  if (profile.faces.empty() && profile.wires.empty())
    throw Error(ErrorCode::InvalidInput, "There is no outline to sweep: the input is empty.",
                "Give a region, curves or a flat face.");
  return profile;
}

gp_Pln planeOf(const TopoDS_Face& face) {
  const GeomLib_IsPlanarSurface planar(BRep_Tool::Surface(face), Tolerance().joining);
  if (!planar.IsPlanar())
    throw Error(ErrorCode::InvalidInput, "The face is curved; only a flat face can be used here.", "Choose a flat face.");
  gp_Pln plane = planar.Plan();
  // The plane found may look the other way than the surface, and the face the other way than its surface.
  const BRepAdaptor_Surface surface(face);
  gp_Pnt point;
  gp_Vec du, dv;
  surface.D1((surface.FirstUParameter() + surface.LastUParameter()) / 2,
             (surface.FirstVParameter() + surface.LastVParameter()) / 2, point, du, dv);
  const gp_Vec outward = du.Crossed(dv) * (face.Orientation() == TopAbs_REVERSED ? -1 : 1);
  if (outward.Dot(gp_Vec(plane.Axis().Direction())) < 0) plane.SetAxis(plane.Axis().Reversed());
  return plane;
}

std::optional<gp_Pln> onlyPlaneOf(const TopoDS_Wire& wire) {
  if (gp_Lin line; isStraight(wire, line)) return {};
  const BRepLib_FindSurface found(wire, Tolerance().joining, Standard_True);
  if (!found.Found()) return {};
  gp_Pln plane = Handle(Geom_Plane)::DownCast(found.Surface())->Pln();
  if (plane.Axis().Direction().Z() < -1e-12) plane.SetAxis(plane.Axis().Reversed());
  return plane;
}

gp_Pln planeOf(const TopoDS_Wire& wire) {
  if (gp_Lin line; isStraight(wire, line)) return planeThrough(line);
  const auto plane = onlyPlaneOf(wire);
  if (!plane)
    throw Error(ErrorCode::InvalidInput, "The curve is not flat; an outline must lie in one plane.",
                "Use it as the path of a pipe, or draw a flat outline.");
  return *plane;
}

}  // namespace blossom::modeling
