#include "geometry/planar/area_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <cstddef>
#include <numeric>

namespace blossom {
namespace {

using AreaKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using AreaVertex = CGAL::Triangulation_vertex_base_with_info_2<int, AreaKernel>;
using AreaFace =
    CGAL::Constrained_triangulation_face_base_2<AreaKernel, CGAL::Triangulation_face_base_with_info_2<int, AreaKernel>>;
// "Plus" remembers how many sides lie on an edge.
using AreaTriangulation = CGAL::Constrained_triangulation_plus_2<CGAL::Constrained_Delaunay_triangulation_2<
    AreaKernel, CGAL::Triangulation_data_structure_2<AreaVertex, AreaFace>, CGAL::Exact_predicates_tag>>;

constexpr std::size_t betweenLooks = 256;

/// A vertex for each corner. Inserted in their own order they would take quadratic time, as those of a convex polygon see
/// long hulls; spatially sorted, each is found beside the one before.
std::vector<AreaTriangulation::Vertex_handle> insertCorners(AreaTriangulation& triangulation,
                                                            const std::vector<AreaKernel::Point_2>& corners,
                                                            const Progress& progress) {
  using Points = CGAL::Pointer_property_map<AreaKernel::Point_2>::const_type;
  std::vector<std::size_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0);
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<AreaKernel, Points>(CGAL::make_property_map(corners)));
  std::vector<AreaTriangulation::Vertex_handle> vertices(corners.size());
  AreaTriangulation::Face_handle near;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k % betweenLooks == 0) progress.check();
    AreaTriangulation::Vertex_handle& vertex = vertices[order[k]];
    vertex = triangulation.insert(corners[order[k]], near);
    near = vertex->face();
  }
  return vertices;
}

void insertPolygons(AreaTriangulation& triangulation, const std::vector<std::vector<Vec2>>& polygons,
                    const Progress& progress) {
  std::vector<AreaKernel::Point_2> corners;
  for (const std::vector<Vec2>& polygon : polygons)
    for (const Vec2& p : polygon) corners.emplace_back(p.x(), p.y());
  const std::vector<AreaTriangulation::Vertex_handle> vertices = insertCorners(triangulation, corners, progress);
  std::size_t first = 0;
  for (const std::vector<Vec2>& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      if (i % betweenLooks == 0) progress.check();
      triangulation.insert_constraint(vertices[first + i], vertices[first + (i + 1) % polygon.size()]);
    }
    first += polygon.size();
  }
}

bool isBoundary(const AreaTriangulation& triangulation, const AreaTriangulation::Edge& edge) {
  const auto& [face, i] = edge;
  return face->is_constrained(i) &&
         triangulation.number_of_enclosing_constraints(face->vertex(face->cw(i)), face->vertex(face->ccw(i))) % 2 == 1;
}

/// Writes into every face, as its info, 1 inside and 0 outside.
void markInside(AreaTriangulation& triangulation) {
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face) face->info() = -1;
  std::vector<AreaTriangulation::Face_handle> open{triangulation.infinite_face()};
  open.front()->info() = 0;
  while (!open.empty()) {
    const AreaTriangulation::Face_handle face = open.back();
    open.pop_back();
    for (int i = 0; i < 3; ++i) {
      const AreaTriangulation::Face_handle next = face->neighbor(i);
      if (next->info() >= 0) continue;
      next->info() = isBoundary(triangulation, {face, i}) ? 1 - face->info() : face->info();
      open.push_back(next);
    }
  }
}

}  // namespace

AreaTriangles triangulateArea(const std::vector<std::vector<Vec2>>& polygons, const Progress& progress) {
  AreaTriangulation triangulation;
  insertPolygons(triangulation, polygons, progress);
  AreaTriangles result;
  if (triangulation.dimension() < 2) return result;
  markInside(triangulation);
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v) {
    v->info() = static_cast<int>(result.points.size());
    result.points.emplace_back(v->point().x(), v->point().y());
  }
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
    if (f->info() == 1) result.triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return result;
}

}  // namespace blossom
