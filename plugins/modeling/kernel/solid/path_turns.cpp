#include "kernel/solid/path_turns.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepLProp_CLProps.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <vector>

namespace blossom::modeling {

namespace {

void addBends(const TopoDS_Edge& edge, PathTurns& turns) {
  const BRepAdaptor_Curve curve(edge);
  constexpr int samples = 32;
  for (int i = 0; i <= samples; ++i) {
    const double t = curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * i / samples;
    BRepLProp_CLProps properties(curve, t, 2, 1e-9);
    if (!properties.IsTangentDefined() || properties.Curvature() * turns.radius <= 1) continue;
    turns.radius = 1 / properties.Curvature();
    turns.bend = curve.Value(t);
  }
}

struct EndDirections {
  gp_Pnt start, end;
  gp_Vec in, out;  ///< unit vectors, or zero where there is none
};

EndDirections endDirections(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  const auto at = [&](double t, gp_Pnt& point, gp_Vec& along) {
    curve.D1(t, point, along);
    along = along.Magnitude() > 1e-9 ? along.Normalized() : gp_Vec(0, 0, 0);
  };
  EndDirections ends;
  at(curve.FirstParameter(), ends.start, ends.in);
  at(curve.LastParameter(), ends.end, ends.out);
  if (edge.Orientation() != TopAbs_REVERSED) return ends;
  return {ends.end, ends.start, ends.out.Reversed(), ends.in.Reversed()};
}

}  // namespace

PathTurns turnsOf(const TopoDS_Wire& path) {
  PathTurns turns;
  std::vector<EndDirections> ends;
  for (BRepTools_WireExplorer edges(path); edges.More(); edges.Next()) {
    addBends(edges.Current(), turns);
    ends.push_back(endDirections(edges.Current()));
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const EndDirections &before = ends[i == 0 ? ends.size() - 1 : i - 1], &after = ends[i];
    if (i == 0 && !BRep_Tool::IsClosed(path)) continue;
    const bool known = before.out.SquareMagnitude() > 0 && after.in.SquareMagnitude() > 0;
    if (const double angle = known ? before.out.Angle(after.in) : 0; angle > turns.corner) {
      turns.corner = angle;
      turns.cornerAt = after.start;
    }
  }
  return turns;
}

}  // namespace blossom::modeling
