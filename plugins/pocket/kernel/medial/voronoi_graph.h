#pragma once
#include <cstddef>
#include <limits>
#include <vector>

#include "core/vector.h"
#include "kernel/medial/boundary.h"

namespace blossom::pocket {

/// The object of a Voronoi cell: the interior of a piece, or its start point.
struct Site {
  bool isPoint = false;
  std::size_t piece = 0;
};

inline constexpr std::size_t atInfinity = std::numeric_limits<std::size_t>::max();

/// The twin of half-edge h is h ^ 1. The cell lies to the left.
struct HalfEdge {
  std::size_t origin = atInfinity;  ///< vertex
  std::size_t next = 0;
  std::size_t cell = 0;
};

/// A Voronoi diagram of pieces and their ends as computed by a library; to be verified before use.
struct VoronoiGraph {
  std::vector<Site> cells;
  std::vector<Vec2> vertices;  ///< mm
  std::vector<HalfEdge> edges;

  [[nodiscard]] std::size_t target(std::size_t h) const { return edges[h ^ 1].origin; }
};

/// By Fortune's sweep line (Boost.Polygon) on an integer grid rotated by `angle` radians. O(n log n).
VoronoiGraph sweepLineGraph(const Boundary&, double angle, const Progress&);
/// As the dual of CGAL's segment Delaunay graph, with exact predicates; about fifty times slower.
VoronoiGraph delaunayGraph(const Boundary&, const Progress&);

}  // namespace blossom::pocket
