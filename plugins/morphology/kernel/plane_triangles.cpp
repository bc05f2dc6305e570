#include "kernel/plane_triangles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "geometry/planar/one_diagonal.h"
#include "kernel/mark_inside.h"

namespace blossom::morphology {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                                       CGAL::No_constraint_intersection_tag>;

/// Without the coordinate in which the plane is steepest, turned so that `normal` looks at the reader.
class Flattened {
 public:
  explicit Flattened(const Vec3& normal) {
    Eigen::Index steep = 0;
    normal.cwiseAbs().maxCoeff(&steep);
    x_ = (steep + 1) % 3;
    y_ = (steep + 2) % 3;
    if (normal[steep] < 0) std::swap(x_, y_);
  }
  [[nodiscard]] Kernel::Point_2 operator()(const Vec3& p) const { return {p[x_], p[y_]}; }

 private:
  Eigen::Index x_ = 0, y_ = 1;
};

}  // namespace

std::vector<std::array<int, 3>> trianglesBetween(const std::vector<Vec3>& points, const std::vector<std::vector<int>>& loops,
                                                 const Vec3& normal) {
  const Flattened flat(normal);
  Cdt cdt;
  std::map<int, Cdt::Vertex_handle> handles;
  try {
    for (const auto& loop : loops)
      for (const int v : loop) {
        const Cdt::Vertex_handle handle = cdt.insert(flat(points[static_cast<std::size_t>(v)]));
        handle->info() = v;
        handles[v] = handle;
      }
    if (cdt.number_of_vertices() != handles.size()) return {};
    for (const auto& loop : loops)
      for (std::size_t k = 0; k < loop.size(); ++k)
        cdt.insert_constraint(handles[loop[k]], handles[loop[(k + 1) % loop.size()]]);
  } catch (const std::exception&) {
    return {};
  }
  takeDiagonalsFromTheLowest(cdt);
  markInside(cdt);
  std::vector<std::array<int, 3>> triangles;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    if (f->info() == 1) triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  sortTriangles(triangles);
  return triangles;
}

}  // namespace blossom::morphology
