#include "geometry/measure/part_form.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GeomLib_IsPlanarSurface.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include "geometry/occt/occt_vector.h"

namespace blossom {

namespace {

using Kind = PartForm::Kind;

PartForm around(Kind kind, const gp_Ax1& axis, double radius = 0, double minor = 0) {
  PartForm form;
  form.kind = kind;
  form.origin = toVec(axis.Location().XYZ());
  form.direction = toVec(axis.Direction().XYZ());
  form.radius = radius;
  form.minor = minor;
  return form;
}

/// A spline that is a line or a circle, recognised by its samples.
PartForm recognised(const BRepAdaptor_Curve& curve) {
  constexpr int count = 33;
  std::vector<Vec3> points;
  points.reserve(count);
  for (int i = 0; i < count; ++i)
    points.push_back(toVec(
        curve.Value(curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * i / (count - 1)).XYZ()));
  const Vec3 &a = points.front(), &b = points[count / 3], &c = points[2 * count / 3];
  double size = 0;
  for (const Vec3& p : points) size = std::max(size, (p - a).norm());
  const double tolerance = std::max(1e-9 * size, 1e-9);
  PartForm form;
  const Vec3 chord = points.back() - a;
  const auto offLine = [&](const Vec3& p) { return (p - a).cross(chord.normalized()).norm() > tolerance; };
  if (chord.norm() > tolerance && std::none_of(points.begin(), points.end(), offLine)) {
    form.kind = Kind::Line;
    form.origin = a;
    form.direction = chord.normalized();
    return form;
  }
  const Vec3 u = b - a, v = c - a, normal = u.cross(v);
  if (normal.norm() <= 1e-9 * size * size) return form;
  const Vec3 toCentre = (u.squaredNorm() * v.cross(normal) + v.squaredNorm() * normal.cross(u)) / (2 * normal.squaredNorm());
  const Vec3 centre = a + toCentre;
  const double radius = toCentre.norm();
  const Vec3 axis = normal.normalized();
  for (const Vec3& p : points)
    if (std::abs((p - centre).norm() - radius) > tolerance || std::abs((p - centre).dot(axis)) > tolerance) return form;
  form.kind = Kind::Circle;
  form.origin = centre;
  form.direction = axis;
  form.radius = radius;
  for (int i = 1; i < count; ++i) {
    const Vec3 from = points[static_cast<std::size_t>(i - 1)] - centre, to = points[static_cast<std::size_t>(i)] - centre;
    form.angle += std::atan2(from.cross(to).dot(axis), from.dot(to));
  }
  form.angle = std::abs(form.angle);
  return form;
}

PartForm formOfCurve(const BRepAdaptor_Curve& curve) {
  switch (curve.GetType()) {
    case GeomAbs_Line: {
      PartForm form = around(Kind::Line, curve.Line().Position());
      form.origin = toVec(curve.Value(curve.FirstParameter()).XYZ());
      return form;
    }
    case GeomAbs_Circle: {
      PartForm form = around(Kind::Circle, curve.Circle().Axis(), curve.Circle().Radius());
      form.angle = curve.LastParameter() - curve.FirstParameter();
      return form;
    }
    case GeomAbs_Ellipse:
      return around(Kind::Ellipse, curve.Ellipse().Axis(), curve.Ellipse().MajorRadius(), curve.Ellipse().MinorRadius());
    default:
      return recognised(curve);
  }
}

PartForm formOfSurface(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face, Standard_False);
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      return around(Kind::Plane, surface.Plane().Axis());
    case GeomAbs_Cylinder:
      return around(Kind::Cylinder, surface.Cylinder().Axis(), surface.Cylinder().Radius());
    case GeomAbs_Cone: {
      PartForm form = around(Kind::Cone, surface.Cone().Axis());
      form.angle = std::abs(surface.Cone().SemiAngle());
      return form;
    }
    case GeomAbs_Sphere: {
      PartForm form = around(Kind::Sphere, surface.Sphere().Position().Axis(), surface.Sphere().Radius());
      return form;
    }
    case GeomAbs_Torus:
      return around(Kind::Torus, surface.Torus().Axis(), surface.Torus().MajorRadius(), surface.Torus().MinorRadius());
    default: {
      const GeomLib_IsPlanarSurface planar(BRep_Tool::Surface(face), 1e-9);
      return planar.IsPlanar() ? around(Kind::Plane, planar.Plan().Axis()) : PartForm();
    }
  }
}

}  // namespace

bool PartForm::hasAxis() const {
  return kind == Kind::Line || kind == Kind::Circle || kind == Kind::Ellipse || kind == Kind::Cylinder ||
         kind == Kind::Cone || kind == Kind::Torus;
}

bool PartForm::hasCentre() const { return kind == Kind::Circle || kind == Kind::Ellipse || kind == Kind::Sphere; }

PartForm formOf(const TopoDS_Shape& shape) {
  PartForm form;
  if (shape.ShapeType() == TopAbs_VERTEX) {
    form.kind = Kind::Point;
    form.origin = toVec(BRep_Tool::Pnt(TopoDS::Vertex(shape)).XYZ());
  } else if (shape.ShapeType() == TopAbs_FACE) {
    form = formOfSurface(TopoDS::Face(shape));
  } else if (shape.ShapeType() == TopAbs_EDGE && !BRep_Tool::Degenerated(TopoDS::Edge(shape))) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(shape));
    form = formOfCurve(curve);
    form.ends = std::pair(toVec(curve.Value(curve.FirstParameter()).XYZ()), toVec(curve.Value(curve.LastParameter()).XYZ()));
  }
  return form;
}

}  // namespace blossom
