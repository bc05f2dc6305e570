// First: the headers after it take away the debugging macros that its own still need.
#include "kernel/exact_types.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/convex_decomposition_3.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "kernel/mark_inside.h"

namespace blossom::morphology {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

/// Each shell by itself, turned outwards.
std::vector<NefShell> shellsOf(const SurfaceMesh& surface) {
  SurfaceMesh work = surface;
  std::vector<SurfaceMesh> parts;
  PMP::split_connected_components(work, parts);
  std::vector<NefShell> shells;
  for (SurfaceMesh& part : parts) {
    part.collect_garbage();
    const Exact::FT volume = PMP::volume(part);
    const bool inside = volume >= 0;
    if (!inside) PMP::reverse_face_orientations(part);
    shells.push_back({nefOf(part), CGAL::abs(volume), inside});
  }
  return shells;
}

struct CollectPoints {
  std::vector<Point>& points;
  void visit(Nef::Vertex_const_handle v) { points.push_back(v->point()); }
  void visit(Nef::Halfedge_const_handle) {}
  void visit(Nef::Halffacet_const_handle) {}
  void visit(Nef::SHalfedge_const_handle) {}
  void visit(Nef::SHalfloop_const_handle) {}
  void visit(Nef::SFace_const_handle) {}
};

Parts decomposed(Nef nef, const Progress& progress) {
  auto list = std::make_shared<PartList>();
  if (nef.is_empty()) return list;
  CGAL::convex_decomposition_3(nef);
  auto volume = nef.volumes_begin();
  for (++volume; volume != nef.volumes_end(); ++volume) {
    progress.check();
    if (!volume->mark()) continue;
    Part part;
    CollectPoints collect{part.points};
    nef.visit_shell_objects(Nef::SFace_const_handle(volume->shells_begin()), collect);
    list->parts.push_back(std::move(part));
  }
  return joinedParts(list, progress);
}

// A facet, its holes and the vertices where it touches itself, as constraints in its plane.
using Projected = CGAL::Projection_traits_3<Exact>;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Projected>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Projected, CGAL::Triangulation_face_base_with_info_2<int, Projected>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Projected, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                                       CGAL::Exact_predicates_tag>;

using VertexNumbers = std::unordered_map<Nef::Vertex_const_handle, std::size_t>;

void addFacet(const Nef::Halffacet_const_handle& facet, const VertexNumbers& numbers, Triangles& out) {
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
  markInside(cdt);
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    if (f->info() == 1) out.faces.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
}

}  // namespace

Triangles trianglesOf(const Nef& nef) {
  Triangles out;
  VertexNumbers numbers;
  for (auto v = nef.vertices_begin(); v != nef.vertices_end(); ++v) {
    numbers.emplace(v, out.points.size());
    out.points.push_back(v->point());
  }
  for (auto f = nef.halffacets_begin(); f != nef.halffacets_end(); ++f)
    if (f->incident_volume()->mark() && !f->twin()->incident_volume()->mark()) addFacet(f, numbers, out);
  return out;
}

Solid solidFrom(Nef nef) {
  auto body = std::make_shared<SolidBody>();
  body->nef = std::move(nef);
  return body;
}

Nef unionOf(const Nef& a, const Nef& b) { return (a + b).regularization(); }

Nef differenceOf(const Nef& a, const Nef& b) { return (a - b).regularization(); }

Nef symmetricDifferenceOf(const Nef& a, const Nef& b) { return (a ^ b).regularization(); }

Nef nefOf(const SurfaceMesh& shell) { return Nef(shell); }

Nef nefOf(std::vector<NefShell> shells) {
  // Whatever lies in a shell is smaller than it.
  std::stable_sort(shells.begin(), shells.end(), [](const NefShell& a, const NefShell& b) { return a.volume > b.volume; });
  if (shells.empty()) return Nef(Nef::EMPTY);
  Nef nef = shells.front().nef;
  for (std::size_t k = 1; k < shells.size(); ++k)
    nef = shells[k].inside ? unionOf(nef, shells[k].nef) : differenceOf(nef, shells[k].nef);
  return nef;
}

Nef nefOf(const SolidBody& body) { return body.nef ? *body.nef : nefOf(shellsOf(body.surface)); }

Parts convexParts(const Solid& solid, const Progress& progress) {
  if (isConvex(solid)) {
    auto list = std::make_shared<PartList>();
    list->parts.push_back({{solid->surface.points().begin(), solid->surface.points().end()}, solid->gridPoints});
    return list;
  }
  return decomposed(nefOf(*solid), progress);
}

Parts convexPartsOutside(const Solid& solid, const Bounds& frame, const Progress& progress) {
  return decomposed(differenceOf(Nef(box(frame)->surface), nefOf(*solid)), progress);
}

}  // namespace blossom::morphology
