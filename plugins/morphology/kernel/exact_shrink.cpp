#include <CGAL/Convex_hull_3/dual/halfspace_intersection_interior_point_3.h>

#include <algorithm>

#include "kernel/exact_types.h"

namespace blossom::morphology {

namespace {

/// The plane moved inwards by as much as the pieces reach outwards: x + b stays behind it for every b.
Exact::Plane_3 movedIn(const Exact::Plane_3& plane, const PartList& parts) {
  const Exact::Vector_3 normal = plane.orthogonal_vector();
  bool any = false;
  Exact::FT reach = 0;
  for (const Part& part : parts.parts)
    for (const Point& p : part.points) {
      const Exact::FT here = normal * (p - CGAL::ORIGIN);
      reach = any ? std::max(reach, here) : here;
      any = true;
    }
  return {plane.a(), plane.b(), plane.c(), plane.d() + reach};
}

/// The corners of {x : x behind all planes}, by the hull of their dual points about a point inside.
std::vector<Point> cornersBehind(const std::vector<Exact::Plane_3>& planes, const Point& inside) {
  std::vector<Point> dual;
  dual.reserve(planes.size());
  for (const auto& plane : planes) {
    const Exact::FT d = plane.orthogonal_vector() * (inside - CGAL::ORIGIN) + plane.d();
    dual.push_back(CGAL::ORIGIN + plane.orthogonal_vector() / (-d));
  }
  const SurfaceMesh hull = hullOf(dual);
  std::vector<Point> corners;
  for (const auto f : hull.faces()) {
    const auto h = hull.halfedge(f);
    const Exact::Plane_3 facet(hull.point(hull.source(h)), hull.point(hull.target(h)),
                               hull.point(hull.target(hull.next(h))));
    corners.push_back(inside + facet.orthogonal_vector() / (-facet.d()));
  }
  return corners;
}

}  // namespace

Solid shrunk(const Solid& convex, const Parts& parts, const Progress& progress) {
  const SurfaceMesh& surface = convex->surface;
  std::vector<Exact::Plane_3> planes;
  for (const auto f : surface.faces()) {
    progress.report(static_cast<double>(planes.size()) / static_cast<double>(surface.number_of_faces()), "Moving faces");
    const auto h = surface.halfedge(f);
    planes.push_back(movedIn(
        {surface.point(surface.source(h)), surface.point(surface.target(h)), surface.point(surface.target(surface.next(h)))},
        *parts));
  }
  const auto inside = CGAL::halfspace_intersection_interior_point_3(planes.begin(), planes.end());
  const auto behind = [&](const Exact::Plane_3& plane) { return plane.has_on_negative_side(*inside); };
  if (!inside || !std::all_of(planes.begin(), planes.end(), behind)) return solidFrom(SurfaceMesh());
  auto body = std::make_shared<SolidBody>();
  body->surface = hullOf(cornersBehind(planes, *inside));
  body->convex = true;
  return body;
}

}  // namespace blossom::morphology
