#include "naming/placed_edges.h"

#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/occt/occt.h"
#include "geometry/occt/sub_shape.h"
#include "geometry/planar/planar.h"

namespace blossom {

namespace {

constexpr double far = std::numeric_limits<double>::infinity();

double toChord(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
  return (a + t * along - p).norm();
}

double toArc(const Arc2& arc, const Vec2& p) {
  const Vec2 from = p - arc.center;
  const double turn = std::atan2(from.y(), from.x()) - arc.start;
  const double whole = 2 * std::numbers::pi, along = arc.sweep > 0 ? turn : -turn;
  const bool beside = along - whole * std::floor(along / whole) <= std::abs(arc.sweep);
  if (beside) return std::abs(from.norm() - arc.radius);
  return std::min((startPoint(arc) - p).norm(), (endPoint(arc) - p).norm());
}

double toPolyline(const std::vector<Vec2>& points, const Vec2& p) {
  double least = far;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) least = std::min(least, toChord(points[i], points[i + 1], p));
  return least;
}

DistanceTo toSegment(const Segment& segment, double chord) {
  const auto inSpace = [](const auto& planar) {
    return [planar](const Vec3& p) { return std::hypot(planar(Vec2(p.x(), p.y())), p.z()); };
  };
  if (const auto* line = std::get_if<Line2>(&segment))
    return inSpace([line = *line](const Vec2& p) { return toChord(line.from, line.to, p); });
  if (const auto* arc = std::get_if<Arc2>(&segment)) return inSpace([arc = *arc](const Vec2& p) { return toArc(arc, p); });
  return inSpace([points = flatten(segment, chord)](const Vec2& p) { return toPolyline(points, p); });
}

DistanceTo toCurve(const Handle(Geom_Curve) & curve, double first, double last) {
  return [curve, first, last](const Vec3& p) {
    const gp_Pnt at(p.x(), p.y(), p.z());
    double least = std::min(at.Distance(curve->Value(first)), at.Distance(curve->Value(last)));
    const GeomAPI_ProjectPointOnCurve foot(at, curve, first, last);
    if (foot.NbPoints() > 0) least = std::min(least, foot.LowerDistance());
    return least;
  };
}

std::vector<DistanceTo> toPaths(const std::vector<Path>& paths, double chord) {
  std::vector<DistanceTo> all;
  for (const Path& path : paths)
    for (const Segment& segment : path.segments) all.push_back(toSegment(segment, chord));
  return all;
}

std::vector<DistanceTo> toEdges(const TopoDS_Shape& shape) {
  std::vector<DistanceTo> all;
  for (const TopoDS_Shape& edge : subShapesOf(shape, TopAbs_EDGE)) {
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(edge), first, last);
    if (curve.IsNull())
      all.emplace_back([](const Vec3&) { return far; });
    else
      all.push_back(toCurve(curve, first, last));
  }
  return all;
}

}  // namespace

std::vector<DistanceTo> distancesToEdges(const Shape& shape, double size) {
  const double chord = std::max(1e-9, 1e-7 * size);
  if (const auto* region = shape.get<Region>()) return toPaths(region->loops, chord);
  if (const auto* curves = shape.get<Curves>()) return toPaths(curves->paths, chord);
  if (const auto* brep = shape.get<Brep>()) return toEdges(brep->shape());
  if (const auto* curve = shape.get<Curve>()) {
    const Handle(Geom_BSplineCurve) made = toOcct(*curve);
    return {toCurve(made, made->FirstParameter(), made->LastParameter())};
  }
  return {};
}

}  // namespace blossom
