#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/convex_hull_3.h>
#include <fmt/format.h>

#include <map>

#include "core/error.h"
#include "kernel/exact_types.h"

namespace blossom::morphology {

namespace {

using Inexact = CGAL::Epick;

using DoublesMesh = CGAL::Surface_mesh<Inexact::Point_3>;

DoublesMesh hullInDoubles(const std::vector<Vec3>& points) {
  std::vector<Inexact::Point_3> doubles;
  doubles.reserve(points.size());
  for (const Vec3& p : points) doubles.emplace_back(p.x(), p.y(), p.z());
  DoublesMesh surface;
  CGAL::convex_hull_3(doubles.begin(), doubles.end(), surface);
  return surface;
}

const std::vector<std::array<int, 3>> boxTriangles{{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};

}  // namespace

SurfaceMesh surfaceFrom(const std::vector<Point>& points, const std::vector<std::array<int, 3>>& faces,
                        const std::string& subject) {
  SurfaceMesh surface;
  surface.reserve(static_cast<SurfaceMesh::size_type>(points.size()),
                  static_cast<SurfaceMesh::size_type>(points.size() + faces.size()),
                  static_cast<SurfaceMesh::size_type>(faces.size()));
  std::vector<SurfaceMesh::Vertex_index> vertices;
  vertices.reserve(points.size());
  for (const Point& p : points) vertices.push_back(surface.add_vertex(p));
  const auto at = [&](int index) { return vertices.at(static_cast<std::size_t>(index)); };
  for (const auto& face : faces)
    if (surface.add_face(at(face[0]), at(face[1]), at(face[2])) == SurfaceMesh::null_face())
      throw Error(ErrorCode::InvalidInput, fmt::format("The faces of {} do not fit together.", subject), "Repair the mesh.");
  for (const auto v : surface.vertices())
    if (surface.is_isolated(v)) surface.remove_vertex(v);
  surface.collect_garbage();
  return surface;
}

SurfaceMesh hullOf(const std::vector<Point>& points) {
  SurfaceMesh surface;
  CGAL::convex_hull_3(points.begin(), points.end(), surface);
  return surface;
}

SurfaceMesh hullOf(const std::vector<Vec3>& points) {
  const DoublesMesh made = hullInDoubles(points);
  SurfaceMesh surface;
  std::vector<SurfaceMesh::Vertex_index> vertices(made.num_vertices());
  for (const auto v : made.vertices()) {
    const auto& p = made.point(v);
    vertices.at(v) = surface.add_vertex(Point(p.x(), p.y(), p.z()));
  }
  for (const auto f : made.faces()) {
    std::vector<SurfaceMesh::Vertex_index> corners;
    for (const auto v : made.vertices_around_face(made.halfedge(f))) corners.push_back(vertices.at(v));
    surface.add_face(corners);
  }
  return surface;
}

Mesh hullTriangles(const std::vector<Vec3>& points) {
  Mesh mesh;
  if (!haveVolume(toPoints(points))) return mesh;
  DoublesMesh made = hullInDoubles(points);
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

bool haveVolume(const std::vector<Point>& points) {
  if (points.empty()) return false;
  const Point& a = points.front();
  const Point *b = nullptr, *c = nullptr;
  for (const Point& p : points) {
    if (!b) {
      if (p != a) b = &p;
    } else if (!c) {
      if (!CGAL::collinear(a, *b, p)) c = &p;
    } else if (!CGAL::coplanar(a, *b, *c, p)) {
      return true;
    }
  }
  return false;
}

Solid solidFrom(SurfaceMesh surface) {
  auto body = std::make_shared<SolidBody>();
  body->surface = std::move(surface);
  return body;
}

Solid box(const Bounds& b) {
  std::vector<Vec3> corners;
  corners.reserve(8);
  for (int k = 0; k < 8; ++k)
    corners.emplace_back((k & 1 ? b.high : b.low).x(), (k & 2 ? b.high : b.low).y(), (k & 4 ? b.high : b.low).z());
  auto body = std::make_shared<SolidBody>();
  body->surface = surfaceFrom(toPoints(corners), boxTriangles, "the box");
  body->convex = true;
  body->gridPoints = corners;
  return body;
}

Solid hull(const std::vector<Vec3>& points) {
  if (!haveVolume(toPoints(points))) return nullptr;
  auto body = std::make_shared<SolidBody>();
  body->surface = hullOf(points);
  body->convex = true;
  for (const auto v : body->surface.vertices()) body->gridPoints.push_back(toVec3(body->surface.point(v)));
  return body;
}

Solid convexSolid(const Mesh& hull) {
  std::vector<std::array<int, 3>> faces;
  faces.reserve(hull.faceCount());
  for (std::size_t f = 0; f < hull.faceCount(); ++f) faces.push_back({hull.face(f)[0], hull.face(f)[1], hull.face(f)[2]});
  auto body = std::make_shared<SolidBody>();
  body->surface = surfaceFrom(toPoints(hull.points), faces, "the hull");
  body->convex = true;
  body->gridPoints = hull.points;
  return body;
}

bool isEmpty(const Solid& solid) {
  return !solid || (solid->nef ? solid->nef->is_empty() : solid->surface.number_of_faces() == 0);
}

bool isConvex(const Solid& solid) { return solid && solid->convex; }

Mesh rounded(const Solid& solid, const Vec3& shift, const Progress& progress) {
  Mesh mesh;
  std::map<std::array<double, 3>, int> indices;
  const auto indexOf = [&](const Point& exact) {
    const Vec3 p = toVec3(exact) + shift;
    const auto [it, fresh] = indices.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(mesh.points.size()));
    if (fresh) mesh.points.push_back(p);
    return it->second;
  };
  const auto addTriangle = [&](int a, int b, int c) {
    if (a != b && b != c && c != a) mesh.addFace(std::array{a, b, c});
  };
  if (isEmpty(solid)) return mesh;
  if (solid->nef) {
    const Triangles triangles = trianglesOf(*solid->nef);
    std::vector<int> index;
    for (const Point& p : triangles.points) index.push_back(indexOf(p));
    for (const auto& t : triangles.faces) addTriangle(index[t[0]], index[t[1]], index[t[2]]);
    return mesh;
  }
  const SurfaceMesh& surface = solid->surface;
  std::vector<int> index(surface.num_vertices() + surface.number_of_removed_vertices());
  for (const auto v : surface.vertices()) {
    progress.check();
    index.at(v) = indexOf(surface.point(v));
  }
  for (const auto f : surface.faces()) {
    const auto h = surface.halfedge(f);
    addTriangle(index.at(surface.source(h)), index.at(surface.target(h)), index.at(surface.target(surface.next(h))));
  }
  return mesh;
}

}  // namespace blossom::morphology
