#include "curve_input.h"

#include <fmt/format.h>

#include <BRepTools_WireExplorer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>

#include "core/error.h"
#include "geometry/occt/edge_curve.h"
#include "geometry/occt/occt.h"
#include "geometry/occt/sub_shape.h"
#include "geometry/planar/planar.h"
#include "kernel/begin/curve_chain.h"

namespace blossom::sweep {

namespace {

[[noreturn]] void refuseCurve(const char* what, const std::string& why, const std::string& hint) {
  throw Error(ErrorCode::InvalidInput, fmt::format("The {} must be one curve; {}.", what, why), hint);
}

/// Farther apart than readers join them, ends do not meet.
double joiningGap() { return 10 * Tolerance{}.joining; }

Curve partOf(const TopoDS_Edge& edge, const char* what) {
  const Handle(Geom_BSplineCurve) spline = edgeSpline(edge);
  if (spline.IsNull()) refuseCurve(what, "an edge has no curve in space", "Choose another edge, or give another file.");
  if (edge.Orientation() == TopAbs_REVERSED) spline->Reverse();
  return fromOcct(spline);
}

Curve curveOfWire(const TopoDS_Wire& wire, const char* what) {
  std::vector<Curve> parts;
  for (BRepTools_WireExplorer edges(wire); edges.More(); edges.Next()) parts.push_back(partOf(edges.Current(), what));
  return chained(parts, joiningGap());
}

Curve curveOfShape(const TopoDS_Shape& shape, const char* what) {
  if (TopExp_Explorer(shape, TopAbs_FACE).More())
    refuseCurve(what, "the shape has faces", "Choose edges of it, or give a drawing or a file that holds a single curve.");
  std::vector<TopoDS_Shape> found;
  for (TopExp_Explorer wires(shape, TopAbs_WIRE); wires.More(); wires.Next()) found.push_back(wires.Current());
  for (TopExp_Explorer edges(shape, TopAbs_EDGE, TopAbs_WIRE); edges.More(); edges.Next()) found.push_back(edges.Current());
  if (found.size() != 1)
    refuseCurve(what, fmt::format("the shape has {} wires and edges", found.size()),
                "Choose the edges that are meant, or join them.");
  if (found[0].ShapeType() == TopAbs_WIRE) return curveOfWire(TopoDS::Wire(found[0]), what);
  return partOf(TopoDS::Edge(found[0]), what);
}

Curve partOf(const Segment& segment) {
  if (const auto* line = std::get_if<Line2>(&segment))
    return {1, {0, 0, 1, 1}, {Vec4(line->from.x(), line->from.y(), 0, 1), Vec4(line->to.x(), line->to.y(), 0, 1)}};
  if (const auto* arc = std::get_if<Arc2>(&segment)) {
    const Vec2 axis(arc->radius, 0);
    return toCurve(ellipticArc(arc->center, axis, 1, arc->start, arc->sweep));
  }
  return toCurve(std::get<Spline2>(segment));
}

Curve curveOfDrawing(const std::vector<Path>& paths, const char* what) {
  if (paths.size() != 1)
    refuseCurve(what, fmt::format("the drawing has {}", paths.size()), "Choose the edges that are meant.");
  std::vector<Curve> parts;
  for (const Segment& segment : paths[0].segments) parts.push_back(partOf(segment));
  return chained(parts, joiningGap());
}

Curve edgeOfDrawing(const std::vector<Path>& paths, int index) {
  std::size_t left = static_cast<std::size_t>(index), count = 0;
  for (const Path& path : paths) {
    if (left < path.segments.size()) return partOf(path.segments[left]);
    left -= path.segments.size();
    count += path.segments.size();
  }
  throw Error(ErrorCode::NotFound, fmt::format("The drawing has {} edges; edge {} is not among them.", count, index),
              "Choose its edges anew.");
}

Curve partOf(const Shape& shape, const char* what, int edge) {
  if (const auto* brep = shape.get<Brep>()) return partOf(edgeOf(*brep, edge), what);
  if (const auto* curves = shape.get<Curves>()) return edgeOfDrawing(curves->paths, edge);
  if (const auto* region = shape.get<Region>()) return edgeOfDrawing(region->loops, edge);
  return curveOf(shape, what);
}

}  // namespace

Curve curveOf(const Shape& shape, const char* what, const std::vector<int>& edges) {
  if (!edges.empty()) {
    std::vector<Curve> parts;
    parts.reserve(edges.size());
    for (const int edge : edges) parts.push_back(partOf(shape, what, edge));
    return chained(inOrder(std::move(parts), joiningGap()), joiningGap());
  }
  if (const auto* curve = shape.get<Curve>()) return *curve;
  if (const auto* brep = shape.get<Brep>()) return curveOfShape(brep->shape(), what);
  if (const auto* curves = shape.get<Curves>()) return curveOfDrawing(joined(*curves).paths, what);
  if (const auto* region = shape.get<Region>()) return curveOfDrawing(region->loops, what);
  refuseCurve(what, "this is none", "Give a drawing or a file with a curve.");
}

}  // namespace blossom::sweep
