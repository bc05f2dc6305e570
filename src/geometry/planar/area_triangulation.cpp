#include "geometry/planar/area_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "geometry/numeric/box_tree.h"
#include "geometry/planar/one_diagonal.h"

namespace blossom {
namespace {

using AreaKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using AreaVertex = CGAL::Triangulation_vertex_base_with_info_2<int, AreaKernel>;
using AreaFace =
    CGAL::Constrained_triangulation_face_base_2<AreaKernel, CGAL::Triangulation_face_base_with_info_2<int, AreaKernel>>;
using AreaTriangulation =
    CGAL::Constrained_Delaunay_triangulation_2<AreaKernel, CGAL::Triangulation_data_structure_2<AreaVertex, AreaFace>,
                                               CGAL::Exact_predicates_tag>;

constexpr std::size_t betweenLooks = 256;

/// A vertex for each corner. Inserted in their own order they would take quadratic time, as those of a convex polygon see
/// long hulls; spatially sorted, each is found beside the one before.
std::vector<AreaTriangulation::Vertex_handle> insertCorners(AreaTriangulation& triangulation,
                                                            const std::vector<AreaKernel::Point_2>& corners,
                                                            const Progress& progress) {
  if (corners.empty()) return {};  // the map below refers to the first one
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
      const auto &from = vertices[first + i], &to = vertices[first + (i + 1) % polygon.size()];
      if (from != to) triangulation.insert_constraint(from, to);
    }
    first += polygon.size();
  }
}

/// Tells whether a place lies in the area, by the sides to the right of it.
class Membership {
 public:
  Membership(const std::vector<std::vector<Vec2>>& polygons, FillRule rule, const Progress& progress) : rule_(rule) {
    std::vector<Box2> boxes;
    for (const std::vector<Vec2>& polygon : polygons)
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        sides_.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
        boxes.push_back(Box2(sides_.back().from).extend(sides_.back().to));
      }
    tree_ = BoxTree<2>(boxes, 4, progress);
    if (!tree_.empty()) right_ = tree_.nodes().front().box.max().x();
  }

  [[nodiscard]] bool contains(const Vec2& p) const {
    int crossings = 0, winding = 0;
    tree_.meeting(Box2(p).extend(Vec2(std::max(right_, p.x()), p.y())), [&](std::size_t i) {
      const auto& [a, b] = sides_[i];
      if ((a.y() > p.y()) == (b.y() > p.y())) return;
      const double turn = (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
      const bool rises = b.y() > a.y();
      if ((turn > 0) != rises) return;
      ++crossings;
      winding += rises ? 1 : -1;
    });
    return rule_ == FillRule::EvenOdd ? crossings % 2 != 0 : winding != 0;
  }

 private:
  struct Side {
    Vec2 from, to;
  };
  FillRule rule_;
  std::vector<Side> sides_;
  BoxTree<2> tree_;
  double right_ = 0;
};

using Faces = std::vector<AreaTriangulation::Face_handle>;

/// The faces around `face` that no side separates from it, marked with `mark`.
Faces facesAround(const AreaTriangulation& triangulation, AreaTriangulation::Face_handle face, int mark) {
  Faces faces{face};
  face->info() = mark;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    for (int i = 0; i < 3; ++i) {
      const AreaTriangulation::Face_handle next = faces[k]->neighbor(i);
      if (next->info() == mark || triangulation.is_constrained({faces[k], i})) continue;
      next->info() = mark;
      faces.push_back(next);
    }
  }
  return faces;
}

/// The middle of the largest of some triangles, as far from all sides as one needs to be.
Vec2 placeAmong(const AreaTriangulation& triangulation, const Faces& faces) {
  const auto smaller = [&](const auto& a, const auto& b) {
    return triangulation.triangle(a).area() < triangulation.triangle(b).area();
  };
  const AreaKernel::Triangle_2 largest = triangulation.triangle(*std::max_element(faces.begin(), faces.end(), smaller));
  const AreaKernel::Point_2 middle = CGAL::centroid(largest);
  return {middle.x(), middle.y()};
}

/// Which side of a side is inside cannot be told from the triangulation, as several sides may lie on an edge.
std::vector<Faces> partsInside(AreaTriangulation& triangulation, const Membership& area, const Progress& progress) {
  constexpr int unseen = 0, seen = 1;
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face) face->info() = unseen;
  facesAround(triangulation, triangulation.infinite_face(), seen);
  std::vector<Faces> parts;
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
    if (face->info() == seen) continue;
    progress.check();
    Faces part = facesAround(triangulation, face, seen);
    if (area.contains(placeAmong(triangulation, part))) parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

AreaTriangles triangulateArea(const std::vector<std::vector<Vec2>>& polygons, const Progress& progress, FillRule rule) {
  AreaTriangulation triangulation;
  insertPolygons(triangulation, polygons, progress);
  takeDiagonalsFromTheLowest(triangulation, progress);
  AreaTriangles result;
  if (triangulation.dimension() < 2) return result;
  const std::vector<Faces> parts = partsInside(triangulation, Membership(polygons, rule, progress), progress);
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v) {
    v->info() = static_cast<int>(result.points.size());
    result.points.emplace_back(v->point().x(), v->point().y());
  }
  for (const Faces& part : parts)
    for (const auto& face : part)
      result.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  sortTriangles(result.triangles);
  return result;
}

}  // namespace blossom
