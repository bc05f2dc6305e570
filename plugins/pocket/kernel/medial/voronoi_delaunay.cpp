#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Segment_Delaunay_graph_hierarchy_2.h>
#include <CGAL/Simple_cartesian.h>

#include <map>
#include <utility>

#include "core/error.h"
#include "kernel/medial/voronoi_graph.h"
#include "kernel/stroke/grid.h"

namespace blossom::pocket {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Traits = CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<Kernel>;
using Delaunay = CGAL::Segment_Delaunay_graph_hierarchy_2<Traits>;
using Face = Delaunay::Face_handle;
using Vertex = Delaunay::Vertex_handle;
using Place = std::pair<double, double>;

Place placeOf(const Kernel::Point_2& p) { return {p.x(), p.y()}; }

class DualMaker {
 public:
  explicit DualMaker(const Boundary& boundary) : boundary_(boundary), grid_(boundary.middle(), boundary.size(), 0) {}

  VoronoiGraph make(const Progress& progress) {
    insert(progress);
    takeVertices();
    takeCells();
    for (auto edge = delaunay_.finite_edges_begin(); edge != delaunay_.finite_edges_end(); ++edge)
      takeEdge(edge->first, edge->second);
    for (std::size_t h = 0; h < graph_.edges.size(); ++h) graph_.edges[h].next = nextOf(h);
    return std::move(graph_);
  }

 private:
  void insert(const Progress& progress) {
    const auto& pieces = boundary_.pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      progress.check();
      const TurnedPoint a = grid_(pieces[i].from);
      const TurnedPoint b = grid_(pieces[i].to);
      const Kernel::Point_2 p(a.x, a.y);
      const Kernel::Point_2 q(b.x, b.y);
      starts_.emplace(placeOf(p), i);
      segments_.emplace(std::pair(placeOf(p), placeOf(q)), i);
      segments_.emplace(std::pair(placeOf(q), placeOf(p)), i);
      delaunay_.insert(p, q);
    }
  }

  void takeVertices() {
    for (auto face = delaunay_.finite_faces_begin(); face != delaunay_.finite_faces_end(); ++face) {
      const Kernel::Point_2 center = delaunay_.primal(Face(face));
      numbers_[Face(face)] = graph_.vertices.size();
      graph_.vertices.push_back(grid_.back(center.x(), center.y()));
    }
  }

  void takeCells() {
    for (auto vertex = delaunay_.finite_vertices_begin(); vertex != delaunay_.finite_vertices_end(); ++vertex) {
      const auto site = vertex->site();
      cells_[Vertex(vertex)] = graph_.cells.size();
      if (site.is_point())
        graph_.cells.push_back({true, starts_.at(placeOf(site.point()))});
      else
        graph_.cells.push_back({false, segments_.at({placeOf(site.source()), placeOf(site.target())})});
    }
  }

  [[nodiscard]] std::size_t numberOf(const Face& face) const {
    const auto found = numbers_.find(face);
    return found == numbers_.end() ? atInfinity : found->second;
  }

  /// The dual of an edge leaves face f through its side i; the cell of the vertex after that side lies to the left.
  void takeEdge(const Face& f, int i) {
    const Face g = f->neighbor(i);
    const int k = g->index(delaunay_.tds().mirror_vertex(f, i));
    add(f, i);
    add(g, k);
  }

  void add(const Face& f, int i) {
    halves_[{f, i}] = graph_.edges.size();
    origins_.emplace_back(f, i);
    graph_.edges.push_back({numberOf(f), 0, cells_.at(f->vertex(Delaunay::Triangulation_data_structure::cw(i)))});
  }

  [[nodiscard]] std::size_t nextOf(std::size_t h) const {
    const auto& [from, side] = origins_[h];
    const Vertex center = from->vertex(Delaunay::Triangulation_data_structure::cw(side));
    Face face = from->neighbor(side);
    while (true) {
      const int i = Delaunay::Triangulation_data_structure::ccw(face->index(center));
      if (const auto found = halves_.find({face, i}); found != halves_.end()) return found->second;
      face = face->neighbor(i);  // past the vertex at infinity
    }
  }

  const Boundary& boundary_;
  TurnedGrid grid_;
  Delaunay delaunay_;
  VoronoiGraph graph_;
  std::map<Place, std::size_t> starts_;
  std::map<std::pair<Place, Place>, std::size_t> segments_;
  std::map<Face, std::size_t> numbers_;
  std::map<Vertex, std::size_t> cells_;
  std::map<std::pair<Face, int>, std::size_t> halves_;
  std::vector<std::pair<Face, int>> origins_;
};

}  // namespace

VoronoiGraph delaunayGraph(const Boundary& boundary, const Progress& progress) { return DualMaker(boundary).make(progress); }

}  // namespace blossom::pocket
