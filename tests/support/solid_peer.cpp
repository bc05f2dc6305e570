#include "support/solid_peer.h"

// First, because the headers after it undefine debugging macros that it needs.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/minkowski_sum_3.h>

#include <algorithm>
#include <unordered_map>

#include "morphology/kernel/mark_inside.h"

namespace blossom::test {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

using Exact = CGAL::Epeck;
using SurfaceMesh = CGAL::Surface_mesh<Exact::Point_3>;
using Nef = CGAL::Nef_polyhedron_3<Exact>;

SurfaceMesh surfaceOf(const Mesh& triangles, double factor) {
  SurfaceMesh surface;
  std::vector<SurfaceMesh::Vertex_index> vertices;
  for (const Vec3& p : triangles.points)
    vertices.push_back(
        surface.add_vertex({Exact::FT(factor) * p.x(), Exact::FT(factor) * p.y(), Exact::FT(factor) * p.z()}));
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    std::vector<SurfaceMesh::Vertex_index> corners;
    for (const int v : triangles.face(f)) corners.push_back(vertices[static_cast<std::size_t>(v)]);
    surface.add_face(corners);
  }
  for (const auto v : surface.vertices())
    if (surface.is_isolated(v)) surface.remove_vertex(v);
  surface.collect_garbage();
  return surface;
}

/// Shells that look outwards are united, larger ones first; the others are subtracted.
Nef nefOf(const Mesh& triangles, double factor) {
  struct Shell {
    Nef nef;
    Exact::FT volume;
    bool isVoid = false;
  };
  SurfaceMesh whole = surfaceOf(triangles, factor);
  std::vector<SurfaceMesh> parts;
  PMP::split_connected_components(whole, parts);
  std::vector<Shell> shells;
  for (SurfaceMesh& part : parts) {
    part.collect_garbage();
    const Exact::FT volume = PMP::volume(part);
    if (volume < 0) PMP::reverse_face_orientations(part);
    shells.push_back({Nef(part), CGAL::abs(volume), volume < 0});
  }
  std::stable_sort(shells.begin(), shells.end(), [](const Shell& a, const Shell& b) { return a.volume > b.volume; });
  Nef nef(Nef::EMPTY);
  for (const Shell& shell : shells)
    nef = shell.isVoid ? (nef - shell.nef).regularization() : (nef + shell.nef).regularization();
  return nef;
}

// A facet, its holes and the vertices where it touches itself, as constraints in its plane.
using Projected = CGAL::Projection_traits_3<Exact>;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Projected>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Projected, CGAL::Triangulation_face_base_with_info_2<int, Projected>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Projected, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                                       CGAL::Exact_predicates_tag>;
using VertexNumbers = std::unordered_map<Nef::Vertex_const_handle, int>;

void addFacet(const Nef::Halffacet_const_handle& facet, const VertexNumbers& numbers, Mesh& out) {
  // The plane of a halffacet looks into its volume: seen against it, triangles run outwards.
  Cdt cdt(Projected(-facet->plane().orthogonal_vector()));
  for (auto cycle = facet->facet_cycles_begin(); cycle != facet->facet_cycles_end(); ++cycle) {
    if (!cycle.is_shalfedge()) {  // a vertex that only touches the facet: neighbours share it, so it becomes a corner
      const auto vertex = Nef::SHalfloop_const_handle { cycle } -> incident_sface()->center_vertex();
      cdt.insert(vertex->point())->info() = numbers.at(vertex);
      continue;
    }
    Nef::SHalfedge_around_facet_const_circulator start(Nef::SHalfedge_const_handle{cycle}), at(start);
    std::vector<Cdt::Vertex_handle> loop;
    CGAL_For_all(at, start) {
      const auto vertex = at->source()->center_vertex();
      loop.push_back(cdt.insert(vertex->point()));
      loop.back()->info() = numbers.at(vertex);
    }
    for (std::size_t k = 0; k < loop.size(); ++k) cdt.insert_constraint(loop[k], loop[(k + 1) % loop.size()]);
  }
  morphology::markInside(cdt);
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    if (f->info() == 1) out.addFace(std::array{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
}

Mesh meshOf(const Nef& nef) {
  Mesh mesh;
  VertexNumbers numbers;
  for (auto v = nef.vertices_begin(); v != nef.vertices_end(); ++v) {
    numbers.emplace(v, static_cast<int>(mesh.points.size()));
    const auto& p = v->point().exact();
    mesh.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  for (auto f = nef.halffacets_begin(); f != nef.halffacets_end(); ++f)
    if (f->incident_volume()->mark() && !f->twin()->incident_volume()->mark()) addFacet(f, numbers, mesh);
  return mesh;
}

}  // namespace

Mesh sumByNef(const Mesh& a, const Mesh& b, double weightA, double weightB) {
  Nef first = nefOf(a, weightA), second = nefOf(b, weightB);
  return meshOf(CGAL::minkowski_sum_3(first, second));
}

}  // namespace blossom::test
