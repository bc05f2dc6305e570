#include <boost/polygon/voronoi.hpp>

#include <algorithm>

#include "kernel/medial/voronoi_graph.h"
#include "kernel/stroke/grid.h"

namespace blossom::pocket {

namespace {

using SweepDiagram = boost::polygon::voronoi_diagram<double>;

Site siteOf(const SweepDiagram::cell_type& cell, const Boundary& boundary) {
  const std::size_t piece = cell.source_index();
  if (cell.contains_segment()) return {false, piece};
  const bool atEnd = cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_END_POINT;
  return {true, atEnd ? boundary.pieces()[piece].next : piece};
}

}  // namespace

VoronoiGraph sweepLineGraph(const Boundary& boundary, double angle, const Progress& progress) {
  const TurnedGrid grid(boundary.middle(), boundary.size(), angle);
  boost::polygon::voronoi_builder<std::int32_t> builder;
  for (const Piece& piece : boundary.pieces()) {
    const TurnedPoint a = grid(piece.from);
    const TurnedPoint b = grid(piece.to);
    builder.insert_segment(a.x, a.y, b.x, b.y);
  }
  SweepDiagram diagram;
  builder.construct(&diagram);
  progress.check();

  VoronoiGraph graph;
  graph.cells.reserve(diagram.cells().size());
  graph.vertices.reserve(diagram.vertices().size());
  graph.edges.reserve(diagram.edges().size());
  for (const auto& cell : diagram.cells()) graph.cells.push_back(siteOf(cell, boundary));
  for (const auto& vertex : diagram.vertices()) graph.vertices.push_back(grid.back(vertex.x(), vertex.y()));
  const auto numberOf = [](const auto* item, const auto& all) {
    return item ? static_cast<std::size_t>(item - all.data()) : atInfinity;
  };
  for (const auto& edge : diagram.edges())
    graph.edges.push_back({numberOf(edge.vertex0(), diagram.vertices()), numberOf(edge.next(), diagram.edges()),
                           numberOf(edge.cell(), diagram.cells())});
  return graph;
}

}  // namespace blossom::pocket
