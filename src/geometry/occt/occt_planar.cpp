#include <fmt/format.h>
#include <BRepAdaptor_Curve.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "geometry/occt/edge_curve.h"
#include "geometry/occt/occt.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/compound.h"

namespace blossom {
namespace {

gp_Pnt lifted(const Vec2& p) { return {p.x(), p.y(), 0}; }
Vec2 flat(const gp_XYZ& p) { return {p.X(), p.Y()}; }

// --- Paths to wires
// ---------------------------------------------------------------------------------------------------------

struct CurveAndRange {
  Handle(Geom_Curve) curve;
  double first, last;
};

CurveAndRange toOcctCurve(const Line2& line) {
  const Vec2 along = line.to - line.from;
  return {new Geom_Line(lifted(line.from), gp_Dir(along.x(), along.y(), 0)), 0, along.norm()};
}

/// A clockwise arc is a counter-clockwise one seen from below.
CurveAndRange toOcctCurve(const Arc2& arc) {
  const gp_Dir axis(0, 0, arc.sweep > 0 ? 1 : -1);
  const gp_Dir toStart(std::cos(arc.start), std::sin(arc.start), 0);
  return {new Geom_Circle(gp_Ax2(lifted(arc.center), axis, toStart), arc.radius), 0, std::abs(arc.sweep)};
}

CurveAndRange toOcctCurve(const Spline2& spline) {
  const Handle(Geom_BSplineCurve) curve = toOcct(toCurve(spline));
  return {Handle(Geom_Curve)(curve), curve->FirstParameter(), curve->LastParameter()};
}

bool isNothing(const Segment& segment) {
  const auto* line = std::get_if<Line2>(&segment);
  return line && (line->to - line->from).norm() <= Precision::Confusion();
}

/// Built edge by edge: the tolerance of a vertex between segments is the gap it bridges.
[[noreturn]] void throwNothing(const Path& path) {
  std::string place;
  if (!path.segments.empty()) {
    const Vec2 start = startPoint(path);
    place = fmt::format(" at ({:.6g}, {:.6g})", start.x(), start.y());
  }
  throw Error(
      ErrorCode::Degenerate, fmt::format("The path{} has no length, so it has no edges.", place),
      "Remove it from the drawing. If it is the first or last frame of a morph out of a point, begin or end the morph "
      "beside the point.");
}

class WireBuilder {
 public:
  TopoDS_Wire build(const Path& path) {
    std::vector<Segment> segments;
    std::remove_copy_if(path.segments.begin(), path.segments.end(), std::back_inserter(segments), isNothing);
    if (segments.empty()) throwNothing(path);
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    const TopoDS_Vertex start = path.closed ? vertexBetween(endPoint(segments.back()), startPoint(segments.front()))
                                            : vertexBetween(startPoint(segments.front()), startPoint(segments.front()));
    TopoDS_Vertex from = start;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const bool last = i + 1 == segments.size();
      const Vec2 end = endPoint(segments[i]);
      const TopoDS_Vertex to = last && path.closed ? start : vertexBetween(end, last ? end : startPoint(segments[i + 1]));
      builder_.Add(wire, edge(segments[i], from, to));
      from = to;
    }
    wire.Closed(path.closed);
    return wire;
  }

 private:
  TopoDS_Vertex vertexBetween(const Vec2& a, const Vec2& b) {
    TopoDS_Vertex vertex;
    builder_.MakeVertex(vertex, lifted((a + b) / 2), Precision::Confusion() + (a - b).norm());
    return vertex;
  }

  TopoDS_Edge edge(const Segment& segment, const TopoDS_Vertex& from, const TopoDS_Vertex& to) {
    const CurveAndRange part = std::visit([](const auto& s) { return toOcctCurve(s); }, segment);
    TopoDS_Edge result;
    builder_.MakeEdge(result, part.curve, Precision::Confusion());
    builder_.Add(result, from.Oriented(TopAbs_FORWARD));
    builder_.Add(result, to.Oriented(TopAbs_REVERSED));
    builder_.Range(result, part.first, part.last);
    return result;
  }

  BRep_Builder builder_;
};

// --- Edges to segments
// ----------------------------------------------------------------------------------------------------------

bool isLevel(const gp_Dir& normal) { return std::abs(std::abs(normal.Z()) - 1) < 1e-12; }

Segment circularArc(const gp_Circ& circle, double first, double last) {
  const double side = circle.Axis().Direction().Z() > 0 ? 1 : -1;
  const gp_Dir x = circle.XAxis().Direction();
  return Arc2{flat(circle.Location().XYZ()), circle.Radius(), std::atan2(x.Y(), x.X()) + side * first,
              side * (last - first)};
}

Segment ellipse(const gp_Elips& e, double first, double last) {
  const gp_Dir x = e.XAxis().Direction();
  const gp_Dir y = e.YAxis().Direction();
  const double side = x.X() * y.Y() - x.Y() * y.X() > 0 ? 1 : -1;
  return ellipticArc(flat(e.Location().XYZ()), e.MajorRadius() * flat(x.XYZ()), side * e.MinorRadius() / e.MajorRadius(),
                     first, last - first);
}

std::optional<Segment> freeForm(const TopoDS_Edge& edge) {
  const Handle(Geom_BSplineCurve) spline = edgeSpline(edge);
  if (spline.IsNull()) return std::nullopt;
  return toSpline(fromOcct(spline));
}

/// z of the edge when it lies in a level plane.
std::optional<double> level(const BRepAdaptor_Curve& curve) {
  constexpr int count = 17;
  std::optional<double> z;
  for (int i = 0; i < count; ++i) {
    const double t = curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * i / (count - 1);
    const double height = curve.Value(t).Z();
    if (z && std::abs(*z - height) > 1e-6) return std::nullopt;
    z = z.value_or(height);
  }
  return z;
}

std::optional<Segment> segment(const TopoDS_Edge& edge, std::optional<double>& z) {
  if (BRep_Tool::Degenerated(edge)) return std::nullopt;
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter();
  const double last = curve.LastParameter();
  if (Precision::IsInfinite(first) || Precision::IsInfinite(last)) return std::nullopt;
  const auto height = level(curve);
  if (!height || (z && std::abs(*z - *height) > 1e-6)) return std::nullopt;
  z = height;
  std::optional<Segment> result;
  if (curve.GetType() == GeomAbs_Line) {
    result = Line2{flat(curve.Value(first).XYZ()), flat(curve.Value(last).XYZ())};
  } else if (curve.GetType() == GeomAbs_Circle && isLevel(curve.Circle().Axis().Direction())) {
    result = circularArc(curve.Circle(), first, last);
  } else if (curve.GetType() == GeomAbs_Ellipse && isLevel(curve.Ellipse().Axis().Direction())) {
    result = ellipse(curve.Ellipse(), first, last);
  } else {
    result = freeForm(edge);
  }
  return result && edge.Orientation() == TopAbs_REVERSED ? reversed(*result) : result;
}

std::size_t edgeCount(const TopoDS_Wire& wire) {
  std::size_t count = 0;
  for (TopExp_Explorer edge(wire, TopAbs_EDGE); edge.More(); edge.Next()) ++count;
  return count;
}

std::vector<TopoDS_Edge> ordered(const TopoDS_Wire& wire) {
  std::vector<TopoDS_Edge> edges;
  for (BRepTools_WireExplorer explorer(wire); explorer.More(); explorer.Next()) edges.push_back(explorer.Current());
  if (edges.size() == edgeCount(wire)) return edges;
  edges.clear();  // edges that only touch, without common vertices: left to `joined`
  for (TopExp_Explorer edge(wire, TopAbs_EDGE); edge.More(); edge.Next()) edges.push_back(TopoDS::Edge(edge.Current()));
  return edges;
}

bool follows(const Path& path, const Segment& next) {
  return (endPoint(path) - startPoint(next)).norm() <= Tolerance().joining;
}

/// The paths of a wire; nothing when an edge leaves the plane.
std::vector<Path> paths(const TopoDS_Wire& wire) {
  std::vector<Path> result;
  std::optional<double> z;
  for (const TopoDS_Edge& edge : ordered(wire)) {
    const auto next = segment(edge, z);
    if (!next) return {};
    if (result.empty() || !follows(result.back(), *next)) result.emplace_back();
    result.back().segments.push_back(*next);
  }
  return joined({result, FillRule::EvenOdd}).paths;
}

}  // namespace

TopoDS_Shape toFaces(const Region& region) {
  const Handle(Geom_Plane) plane = new Geom_Plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  BRep_Builder builder;
  std::vector<TopoDS_Shape> faces;
  for (const RegionComponent& component : components(region)) {
    TopoDS_Face face;
    builder.MakeFace(face, plane, Precision::Confusion());
    builder.Add(face, WireBuilder().build(region.loops[component.outer]));
    for (const std::size_t hole : component.holes) builder.Add(face, WireBuilder().build(region.loops[hole]));
    faces.push_back(face);
  }
  return compoundOf(faces);
}

TopoDS_Shape toWires(const Curves& curves) {
  std::vector<TopoDS_Shape> wires;
  for (const Path& path : curves.paths) wires.push_back(WireBuilder().build(path));
  return compoundOf(wires);
}

Curves planarCurves(const TopoDS_Shape& shape) {
  Curves curves;
  for (TopExp_Explorer wire(shape, TopAbs_WIRE); wire.More(); wire.Next())
    for (Path& path : paths(TopoDS::Wire(wire.Current()))) curves.paths.push_back(std::move(path));
  for (TopExp_Explorer edge(shape, TopAbs_EDGE, TopAbs_WIRE); edge.More(); edge.Next()) {
    std::optional<double> z;
    const auto single = segment(TopoDS::Edge(edge.Current()), z);
    if (!single) continue;
    const bool closed =
        (startPoint(*single) - endPoint(*single)).norm() <= Tolerance().joining && length(*single) > Tolerance().joining;
    curves.paths.push_back({{*single}, closed, {}, {}});
  }
  return curves;
}

}  // namespace blossom
