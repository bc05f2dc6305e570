#include "geometry/measure/measure_between.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <Eigen/Geometry>
#include <Standard_Failure.hxx>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/tolerance.h"
#include "geometry/measure/closest_points.h"
#include "geometry/measure/part_form.h"
#include "geometry/measure/part_relation.h"
#include "geometry/mesh/closed_triangles.h"
#include "geometry/occt/occt_reason.h"
#include "geometry/shape/bounds.h"
#include "geometry/shape/compound.h"
#include "geometry/tessellate/tessellate.h"

namespace blossom {

namespace {

std::optional<Vec3> inside(const std::vector<Vec3>& points, const PartGeometry& part, const Progress& progress) {
  if (!part.exact.IsNull()) return pointInside(points, part.exact, progress);
  if (!part.full) return std::nullopt;
  for (const Vec3& p : points) {
    progress.check();
    if (std::abs(windingNumber(part.triangles, p)) > 0.5) return p;
  }
  return std::nullopt;
}

std::vector<Vec3> pointsOfParts(const PartGeometry& part) {
  if (!part.exact.IsNull()) return representatives(part.exact);
  return {part.triangles.front()[0]};
}

/// Triangles and lines within `chord` of an exact shape.
TriangleTree coarse(const TopoDS_Shape& shape, double chord, const Progress& progress) {
  TessellationOptions options;
  options.chord = chord;
  const Tessellation t = tessellate(Shape(Brep(shape)), options, progress);
  std::vector<Triangle3> triangles;
  triangles.reserve(t.triangles.size());
  const auto at = [&](int i) { return t.points[static_cast<std::size_t>(i)]; };
  for (const auto& triangle : t.triangles) triangles.push_back({at(triangle[0]), at(triangle[1]), at(triangle[2])});
  for (const auto& line : t.edges)
    for (std::size_t i = 0; i + 1 < line.size(); ++i) triangles.push_back({line[i], line[i + 1], line[i + 1]});
  for (const Vec3& p : representatives(shape)) triangles.push_back({p, p, p});
  if (triangles.empty()) throw Error(ErrorCode::InvalidInput, "A shape without parts has no distance to anything.");
  return TriangleTree(std::move(triangles));
}

TopoDS_Shape faceOf(const Triangle3& t) {
  const auto point = [](const Vec3& p) { return gp_Pnt(p.x(), p.y(), p.z()); };
  BRepBuilderAPI_MakePolygon polygon(point(t[0]), point(t[1]), point(t[2]), Standard_True);
  if (!polygon.IsDone()) return {};
  BRepBuilderAPI_MakeFace face(polygon.Wire(), Standard_True);
  return face.IsDone() ? TopoDS_Shape(face.Face()) : TopoDS_Shape();
}

/// Only triangles that may contain the nearest point are compared with the exact shape.
FootPoints exactToTriangles(const TopoDS_Shape& exact, const std::vector<Triangle3>& triangles, const Progress& progress) {
  const Bounds box = bounds(Shape(Brep(exact)));
  const double chord = std::max(1e-3 * box.diagonal(), 1e-6);
  const TriangleTree near = coarse(exact, chord, progress.part(0, 0.2)), all(triangles);
  const FootPoints rough = near.closest(all, progress);
  std::vector<TopoDS_Shape> faces;
  for (const std::size_t i : all.within(near, rough.distance() + 2 * chord, progress)) {
    const TopoDS_Shape face = faceOf(triangles[i]);
    if (!face.IsNull()) faces.push_back(face);  // else collapsed: its neighbours have the same points
  }
  return faces.empty() ? rough : closestPoints(exact, compoundOf(faces), progress.part(0.2, 1));
}

FootPoints surfaceDistance(const PartGeometry& a, const PartGeometry& b, const Progress& progress) {
  if (!a.exact.IsNull() && !b.exact.IsNull()) return closestPoints(a.exact, b.exact, progress);
  if (!a.exact.IsNull()) return exactToTriangles(a.exact, b.triangles, progress);
  if (b.exact.IsNull()) return TriangleTree(a.triangles).closest(TriangleTree(b.triangles), progress);
  const FootPoints turned = exactToTriangles(b.exact, a.triangles, progress);
  return {turned.second, turned.first};
}

FootPoints footPoints(const PartGeometry& a, const PartGeometry& b, const Progress& progress) {
  FootPoints found = surfaceDistance(a, b, progress);
  if (found.distance() <= Tolerance().confusion) return {found.first, found.first};
  if (!a.exact.IsNull() && !b.exact.IsNull()) return found;  // solids are handled already
  if (const auto point = inside(pointsOfParts(a), b, progress)) return {*point, *point};
  if (const auto point = inside(pointsOfParts(b), a, progress)) return {*point, *point};
  return found;
}

/// What rounding leaves of a zero is a zero; far below any tolerance.
double withoutNoise(double value) { return value < 1e-11 ? 0 : value; }

Measurement related(const MeasuredPart& one, const MeasuredPart& other, const Progress& progress) {
  const PartGeometry a = geometryOf(one), b = geometryOf(other);
  const FootPoints feet = footPoints(a, b, progress);
  const Vec3 delta = (feet.second - feet.first).cwiseAbs().unaryExpr([](double d) { return withoutNoise(d); });
  Measurement m;
  m.kind = "distance";
  m.values = {{"distance", feet.distance(), MeasureUnit::Length},
              {"delta_x", delta.x(), MeasureUnit::Length},
              {"delta_y", delta.y(), MeasureUnit::Length},
              {"delta_z", delta.z(), MeasureUnit::Length}};
  m.lines = {{feet.first, feet.second}};
  m.label = (feet.first + feet.second) / 2;
  addRelation(m, a, b, feet);
  return m;
}

}  // namespace

Measurement measureBetween(const MeasuredPart& a, const MeasuredPart& b, const Progress& progress) {
  progress.check();
  try {
    return related(a, b, progress);
  } catch (const Standard_Failure& failure) {
    throw Error(ErrorCode::Degenerate, std::string("The parts cannot be measured: ") + reasonOf(failure) + ".",
                "Check the shapes; they may come from a damaged file.");
  }
}

}  // namespace blossom
