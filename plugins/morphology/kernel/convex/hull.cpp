#include "kernel/convex/hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

namespace blossom::morphology {

namespace {

using Inexact = CGAL::Epick;
using Point = Inexact::Point_3;

bool lieInPlane(const std::vector<Point>& points) {
  const Point *b = nullptr, *c = nullptr;
  for (const Point& p : points) {
    if (!b) {
      if (p != points.front()) b = &p;
    } else if (!c) {
      if (!CGAL::collinear(points.front(), *b, p)) c = &p;
    } else if (!CGAL::coplanar(points.front(), *b, *c, p)) {
      return false;
    }
  }
  return true;
}

Point toPoint(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

int sideOfPlane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return CGAL::orientation(toPoint(a), toPoint(b), toPoint(c), toPoint(d));
}

Mesh hullTriangles(const std::vector<Vec3>& points) {
  std::vector<Point> doubles;
  doubles.reserve(points.size());
  for (const Vec3& p : points) doubles.push_back(toPoint(p));
  Mesh mesh;
  if (lieInPlane(doubles)) return mesh;
  CGAL::Surface_mesh<Point> made;
  CGAL::convex_hull_3(doubles.begin(), doubles.end(), made);
  CGAL::Polygon_mesh_processing::triangulate_faces(made);
  mesh.points.reserve(made.number_of_vertices());
  for (const auto v : made.vertices()) {
    const auto& p = made.point(v);
    mesh.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : made.faces()) {
    std::vector<int> corners;
    for (const auto v : made.vertices_around_face(made.halfedge(f))) corners.push_back(static_cast<int>(v));
    mesh.addFace(corners);
  }
  return mesh;
}

}  // namespace blossom::morphology
