#include "kernel/convex/hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include "kernel/convex/hull_facets.h"

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

/// Without the sign of zeros, by which equal points could be told from one another.
Point toPoint(const Vec3& p) { return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}; }

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
  const auto facets = hullFacets(made, Inexact().coplanar_3_object());
  mesh.points.reserve(facets.points.size());
  for (const Point& p : facets.points) mesh.points.emplace_back(p.x(), p.y(), p.z());
  for (const auto& triangle : facets.triangles) mesh.addFace(triangle);
  return mesh;
}

}  // namespace blossom::morphology
