#include "geometry/tessellate/face_mesh.h"

#include <Eigen/Geometry>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/numeric/boxes.h"
#include "geometry/occt/occt_vector.h"

namespace blossom {
namespace {

std::optional<Vec3> surfaceNormal(const BRepAdaptor_Surface& surface, const gp_XY& uv) {
  gp_Pnt p;
  gp_Vec du, dv;
  surface.D1(uv.X(), uv.Y(), p, du, dv);
  const Vec3 normal = toVec(du.XYZ()).cross(toVec(dv.XYZ()));
  const double speed = std::max(du.SquareMagnitude(), dv.SquareMagnitude());
  if (!(normal.norm() > 1e-8 * speed)) return std::nullopt;
  return normal.normalized();
}

/// The middle of a triangle's parameters. A corner with a collapsed parameter counts in the other one only: the corner in
/// the tip of a cone has whatever angle the mesher gave it.
gp_XY middleParameters(const FaceMesh& mesh, const Poly_Triangle& triangle, const std::vector<Collapsed>& collapsed) {
  gp_XY sum(0, 0);
  int countU = 0, countV = 0;
  for (int k = 1; k <= 3; ++k) {
    const gp_Pnt2d uv = mesh.triangulation->UVNode(triangle.Value(k));
    const Collapsed here = collapsed[static_cast<std::size_t>(triangle.Value(k) - 1)];
    if (here != Collapsed::U) {
      sum.SetX(sum.X() + uv.X());
      ++countU;
    }
    if (here != Collapsed::V) {
      sum.SetY(sum.Y() + uv.Y());
      ++countV;
    }
  }
  return {sum.X() / std::max(1, countU), sum.Y() / std::max(1, countV)};
}

/// The parameters of all nodes.
Box2 parameterBox(const Poly_Triangulation& triangulation) {
  Box2 box;
  for (int i = 1; i <= triangulation.NbNodes(); ++i) {
    const gp_Pnt2d uv = triangulation.UVNode(i);
    box.extend(Vec2(uv.X(), uv.Y()));
  }
  return box;
}

/// Whether all parameters along an axis are the same place as `uv`. A derivative of length 0 is not enough: it also comes
/// from two rows of poles at one place.
bool isOnePlace(const BRepAdaptor_Surface& surface, const gp_Pnt2d& uv, int axis, const Box2& box) {
  const gp_Pnt place = surface.Value(uv.X(), uv.Y());
  for (const double share : {0.0, 0.5, 1.0}) {
    gp_Pnt2d other = uv;
    other.SetCoord(axis + 1, box.min()[axis] + share * (box.max()[axis] - box.min()[axis]));
    if (surface.Value(other.X(), other.Y()).Distance(place) > Precision::Confusion()) return false;
  }
  return true;
}

}  // namespace

gp_Pnt2d parameterCenter(const Poly_Triangulation& triangulation) {
  gp_XY sum(0, 0);
  for (int i = 1; i <= triangulation.NbNodes(); ++i) sum += triangulation.UVNode(i).XY();
  return gp_Pnt2d(sum / std::max(1, triangulation.NbNodes()));
}

Vec3 normalAt(const BRepAdaptor_Surface& surface, const gp_Pnt2d& uv, const gp_Pnt2d& center) {
  for (const double step : {0.0, 1e-5, 1e-3, 1e-1})
    if (const auto normal = surfaceNormal(surface, uv.XY() + (center.XY() - uv.XY()) * step)) return *normal;
  return {0, 0, 1};
}

SurfaceCurvature curvatureAt(const BRepAdaptor_Surface& surface, const gp_Pnt2d& uv, const gp_Pnt2d& center) {
  for (const double step : {0.0, 1e-4, 1e-3, 1e-2}) {
    const gp_XY place = uv.XY() + (center.XY() - uv.XY()) * step;
    gp_Pnt p;
    gp_Vec du, dv, duu, dvv, duv;
    surface.D2(place.X(), place.Y(), p, du, dv, duu, dvv, duv);
    const auto vec = [](const gp_Vec& d) { return toVec(d.XYZ()); };
    if (const auto found = curvatureOf({vec(du), vec(dv), vec(duu), vec(duv), vec(dvv)})) return *found;
  }
  return {};
}

std::vector<Collapsed> collapsedParameters(const Poly_Triangulation& triangulation, const BRepAdaptor_Surface& surface) {
  constexpr double nothing = 1e-8;
  const Box2 box = parameterBox(triangulation);
  std::vector<Collapsed> collapsed(static_cast<std::size_t>(triangulation.NbNodes()), Collapsed::No);
  for (int i = 1; i <= triangulation.NbNodes(); ++i) {
    const gp_Pnt2d uv = triangulation.UVNode(i);
    gp_Pnt p;
    gp_Vec du, dv;
    surface.D1(uv.X(), uv.Y(), p, du, dv);
    if (du.Magnitude() <= nothing * dv.Magnitude() && isOnePlace(surface, uv, 0, box))
      collapsed[static_cast<std::size_t>(i - 1)] = Collapsed::U;
    else if (dv.Magnitude() <= nothing * du.Magnitude() && isOnePlace(surface, uv, 1, box))
      collapsed[static_cast<std::size_t>(i - 1)] = Collapsed::V;
  }
  return collapsed;
}

double sag(const FaceMesh& mesh, const BRepAdaptor_Surface& surface, const Poly_Triangle& triangle,
           const std::vector<Collapsed>& collapsed) {
  int a = 0, b = 0, c = 0;
  triangle.Get(a, b, c);
  const Poly_Triangulation& t = *mesh.triangulation;
  const auto at = [&](int i) { return toVec(t.Node(i).Transformed(mesh.location.Transformation()).XYZ()); };
  const gp_XY middle = middleParameters(mesh, triangle, collapsed);
  const Vec3 p = at(a);
  const Vec3 normal = (at(b) - p).cross(at(c) - p);
  // Triangles without area, such as two places on one ruling of a cone and its tip, cover nothing; their normals are noise.
  const double longest = std::max({(at(b) - p).norm(), (at(c) - p).norm(), (at(c) - at(b)).norm()});
  if (!(normal.norm() > 1e-9 * longest * longest)) return 0;
  return std::abs((toVec(surface.Value(middle.X(), middle.Y()).XYZ()) - p).dot(normal.normalized()));
}

}  // namespace blossom
