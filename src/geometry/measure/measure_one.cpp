// Figures of one part.
#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Eigen/Geometry>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/error.h"
#include "geometry/measure/measure_patch.h"
#include "geometry/measure/part_form.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/occt/occt_reason.h"
#include "geometry/shape/bounds.h"

namespace blossom {

namespace {

using Kind = PartForm::Kind;

void add(Measurement& m, const char* name, double value, MeasureUnit unit = MeasureUnit::Length) {
  m.values.push_back({name, value, unit});
}

double figure(const TopoDS_Shape& shape, const char* name, const Progress& progress) {
  for (const Measure& measured : measure(Shape(Brep(shape)), progress).values)
    if (measured.name == name) return std::get<double>(measured.value);
  throw Error(ErrorCode::Degenerate, "The part has no " + std::string(name) + ".", "It may come from a damaged file.");
}

void addCentre(Measurement& m, const Vec3& centre) {
  add(m, "center_x", centre.x());
  add(m, "center_y", centre.y());
  add(m, "center_z", centre.z());
}

Measurement finished(Measurement m) {
  m.kind = m.values.front().name;
  return m;
}

Measurement ofPoint(const Vec3& p) {
  Measurement m;
  m.label = p;
  add(m, "x", p.x());
  add(m, "y", p.y());
  add(m, "z", p.z());
  return finished(std::move(m));
}

std::vector<Vec3> along(const BRepAdaptor_Curve& curve) {
  constexpr int count = 65;
  std::vector<Vec3> line;
  line.reserve(count);
  for (int i = 0; i < count; ++i) {
    const gp_Pnt p =
        curve.Value(curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * i / (count - 1));
    line.emplace_back(p.X(), p.Y(), p.Z());
  }
  return line;
}

/// Whole circles show their diameter, arcs their radius; `onIt` lies on the circle.
void addRound(Measurement& m, const PartForm& form, bool whole, const Vec3& onIt) {
  add(m, whole ? "diameter" : "radius", whole ? 2 * form.radius : form.radius);
  add(m, whole ? "radius" : "diameter", whole ? form.radius : 2 * form.radius);
  const Vec3 centre = form.origin + (onIt - form.origin).dot(form.direction) * form.direction *
                                        (form.kind == Kind::Cylinder || form.kind == Kind::Circle ? 1 : 0);
  m.lines = {{whole ? Vec3(2 * centre - onIt) : centre, onIt}};
  m.label = whole ? centre : Vec3((centre + onIt) / 2);
}

Measurement ofEdge(const TopoDS_Edge& edge, const PartForm& form, const Progress& progress) {
  if (BRep_Tool::Degenerated(edge))
    throw Error(ErrorCode::Degenerate, "The edge has shrunk to a point.", "Pick the point instead.");
  const std::vector<Vec3> line = along(BRepAdaptor_Curve(edge));
  Measurement m;
  m.lines = {line};
  m.label = line[line.size() / 2];
  const double length = figure(edge, "length", progress);
  if (form.kind == Kind::Circle) {
    const bool whole = form.angle > fullTurn - 1e-9;
    addRound(m, form, whole, line[line.size() / 2]);
    add(m, "length", length);
    if (!whole) add(m, "angle", toDegrees(form.angle), MeasureUnit::Angle);
    addCentre(m, form.origin);
    return finished(std::move(m));
  }
  add(m, "length", length);
  if (form.kind == Kind::Ellipse) {
    add(m, "major_radius", form.radius);
    add(m, "minor_radius", form.minor);
    addCentre(m, form.origin);
  } else if (form.kind == Kind::Line) {
    const Vec3 delta = line.back() - line.front();
    add(m, "delta_x", std::abs(delta.x()));
    add(m, "delta_y", std::abs(delta.y()));
    add(m, "delta_z", std::abs(delta.z()));
  }
  return finished(std::move(m));
}

/// Length of the boundary; a seam is not one.
double perimeter(const TopoDS_Face& face, const Progress& progress) {
  double sum = 0;
  for (TopExp_Explorer explorer(face, TopAbs_EDGE); explorer.More(); explorer.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(explorer.Current());
    if (!BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, face)) sum += figure(edge, "length", progress);
  }
  return sum;
}

Measurement ofFace(const TopoDS_Face& face, const PartForm& form, const Progress& progress) {
  const MeasurePatch patch(face);
  const auto& samples = patch.samples();
  const Vec3 middle = patch.box().center();
  Measurement m;
  m.label = std::min_element(samples.begin(), samples.end(), [&](const auto& a, const auto& b) {
              return (a.point - middle).squaredNorm() < (b.point - middle).squaredNorm();
            })->point;
  if (form.kind == Kind::Cylinder || form.kind == Kind::Sphere)
    addRound(m, form, patch.high()[0] - patch.low()[0] > fullTurn - 1e-9, m.label);
  if (form.kind == Kind::Torus) {
    add(m, "major_radius", form.radius);
    add(m, "minor_radius", form.minor);
  }
  if (form.kind == Kind::Cone) add(m, "half_angle", toDegrees(form.angle), MeasureUnit::Angle);
  add(m, "area", figure(face, "area", progress), MeasureUnit::Area);
  if (const double length = perimeter(face, progress); length > 0) add(m, "perimeter", length);
  if (form.kind == Kind::Sphere || form.kind == Kind::Torus) addCentre(m, form.origin);
  return finished(std::move(m));
}

Measurement ofTriangles(const Mesh& mesh, std::size_t face) {
  const std::vector<Vec3> points = facePoints(mesh, face);
  double area = 0, length = 0;
  for (const auto& t : triangulate(points)) {
    const auto at = [&](int i) { return points[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])]; };
    area += (at(1) - at(0)).cross(at(2) - at(0)).norm() / 2;
  }
  Measurement m;
  for (std::size_t i = 0; i < points.size(); ++i) {
    length += (points[(i + 1) % points.size()] - points[i]).norm();
    m.label += points[i] / static_cast<double>(points.size());
  }
  add(m, "area", area, MeasureUnit::Area);
  add(m, "perimeter", length);
  return finished(std::move(m));
}

/// As tight as the surfaces allow, unlike the box of their poles.
Bounds tightBox(const PartGeometry& part, const Progress& progress) {
  Bounds result;
  for (const Triangle3& t : part.triangles)
    for (const Vec3& p : t) result.add(p);
  for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
    const TopAbs_ShapeEnum above = kind == TopAbs_FACE ? TopAbs_SHAPE : kind == TopAbs_EDGE ? TopAbs_FACE : TopAbs_EDGE;
    if (part.exact.IsNull()) break;
    for (TopExp_Explorer explorer(part.exact, kind, above); explorer.More(); explorer.Next()) {
      progress.check();
      Bnd_Box box;
      BRepBndLib::AddOptimal(explorer.Current(), box, Standard_False, Standard_False);
      if (box.IsVoid() || box.IsOpen()) continue;
      box.SetGap(0);
      const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
      result.add(Vec3(low.X(), low.Y(), low.Z()));
      result.add(Vec3(high.X(), high.Y(), high.Z()));
    }
  }
  return result;
}

Measurement ofWhole(const MeasuredPart& part, const Progress& progress) {
  const PartGeometry geometry = geometryOf(part);  // says what cannot be measured
  Measurement m;
  for (const Measure& figure : measure(part.shape, progress.part(0, 0.5)).values)
    if (figure.unit == MeasureUnit::Volume || figure.unit == MeasureUnit::Area || figure.unit == MeasureUnit::Length)
      m.values.push_back(figure);
  const Bounds box = tightBox(geometry, progress);
  m.label = box.center();
  add(m, "size_x", box.high.x() - box.low.x());
  add(m, "size_y", box.high.y() - box.low.y());
  add(m, "size_z", box.high.z() - box.low.z());
  return finished(std::move(m));
}

Measurement measured(const MeasuredPart& part, const Progress& progress) {
  if (part.kind == SubShapeKind::Whole) return ofWhole(part, progress);
  const PartGeometry geometry = geometryOf(part);
  if (geometry.form.kind == Kind::Point) return ofPoint(geometry.form.origin);
  if (const Mesh* mesh = part.shape.get<Mesh>()) return ofTriangles(*mesh, static_cast<std::size_t>(part.index));
  if (geometry.exact.ShapeType() == TopAbs_EDGE) return ofEdge(TopoDS::Edge(geometry.exact), geometry.form, progress);
  if (geometry.exact.ShapeType() == TopAbs_FACE) return ofFace(TopoDS::Face(geometry.exact), geometry.form, progress);
  return ofWhole({part.shape, SubShapeKind::Whole, -1}, progress);  // a region of several components
}

}  // namespace

Measurement measureOne(const MeasuredPart& part, const Progress& progress) {
  progress.check();
  try {
    return measured(part, progress);
  } catch (const Standard_Failure& failure) {
    throw Error(ErrorCode::Degenerate, std::string("The part cannot be measured: ") + reasonOf(failure) + ".",
                "Check the shape; it may come from a damaged file.");
  }
}

}  // namespace blossom
