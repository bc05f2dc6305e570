#include <CGAL/Convex_hull_3/dual/halfspace_intersection_interior_point_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <map>

#include "kernel/convex/hull.h"
#include "kernel/convex/hull_facets.h"

namespace blossom::morphology {

namespace {

using Exact = CGAL::Epeck;
using ExactPoint = Exact::Point_3;
using ExactHull = CGAL::Surface_mesh<ExactPoint>;

ExactPoint toExact(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

Vec3 toNearest(const ExactPoint& p) {
  const auto& e = p.exact();
  return {CGAL::to_double(e.x()), CGAL::to_double(e.y()), CGAL::to_double(e.z())};
}

ExactHull exactHull(const std::vector<ExactPoint>& points) {
  ExactHull hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  return hull;
}

/// The plane moved inwards by as much as the points reach outwards: x + p stays behind it for every p.
Exact::Plane_3 movedIn(const Exact::Plane_3& plane, std::span<const Vec3> points) {
  const Exact::Vector_3 normal = plane.orthogonal_vector();
  Exact::FT reach = normal * (toExact(points.front()) - CGAL::ORIGIN);
  for (const Vec3& p : points.subspan(1)) reach = std::max<Exact::FT>(reach, normal * (toExact(p) - CGAL::ORIGIN));
  return {plane.a(), plane.b(), plane.c(), plane.d() + reach};
}

/// The corners of {x : x behind all planes}, by the hull of their dual points about a point inside.
std::vector<ExactPoint> cornersBehind(const std::vector<Exact::Plane_3>& planes, const ExactPoint& inside) {
  std::vector<ExactPoint> dual;
  dual.reserve(planes.size());
  for (const auto& plane : planes) {
    const Exact::FT d = plane.orthogonal_vector() * (inside - CGAL::ORIGIN) + plane.d();
    dual.push_back(CGAL::ORIGIN + plane.orthogonal_vector() / (-d));
  }
  const ExactHull hull = exactHull(dual);
  std::vector<ExactPoint> corners;
  for (const auto f : hull.faces()) {
    const auto h = hull.halfedge(f);
    const Exact::Plane_3 facet(hull.point(hull.source(h)), hull.point(hull.target(h)),
                               hull.point(hull.target(hull.next(h))));
    corners.push_back(inside + facet.orthogonal_vector() / (-facet.d()));
  }
  return corners;
}

/// Corners that rounding makes equal become one.
Mesh roundedTriangles(const ExactHull& hull) {
  const auto facets = hullFacets(hull, Exact().coplanar_3_object());
  Mesh mesh;
  std::map<std::array<double, 3>, int> indices;
  std::vector<int> numbers;
  for (const ExactPoint& exact : facets.points) {
    const Vec3 p = toNearest(exact);
    const auto [it, fresh] = indices.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(mesh.points.size()));
    if (fresh) mesh.points.push_back(p);
    numbers.push_back(it->second);
  }
  for (const auto& triangle : facets.triangles) {
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = numbers[static_cast<std::size_t>(triangle[k])];
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) mesh.addFace(corners);
  }
  return mesh;
}

}  // namespace

Mesh shrunk(const Mesh& hull, std::span<const Vec3> points) {
  std::vector<Exact::Plane_3> planes;
  planes.reserve(hull.faceCount());
  for (std::size_t f = 0; f < hull.faceCount(); ++f) {
    const auto face = hull.face(f);
    const auto at = [&](std::size_t k) { return toExact(hull.points[static_cast<std::size_t>(face[k])]); };
    planes.push_back(movedIn({at(0), at(1), at(2)}, points));
  }
  const auto inside = CGAL::halfspace_intersection_interior_point_3(planes.begin(), planes.end());
  const auto behind = [&](const Exact::Plane_3& plane) { return plane.has_on_negative_side(*inside); };
  if (!inside || !std::all_of(planes.begin(), planes.end(), behind)) return {};
  return roundedTriangles(exactHull(cornersBehind(planes, *inside)));
}

}  // namespace blossom::morphology
