#pragma once
#include <cstddef>
#include <limits>
#include <vector>

#include "core/vector.h"
#include "kernel/medial/boundary.h"

namespace blossom::pocket {

/// What a Voronoi cell belongs to: the interior of a piece, or the point where it begins.
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

/// A Voronoi diagram of pieces and their ends as a library gave it: to be checked before it is used.
struct VoronoiGraph {
  std::vector<Site> cells;
  std::vector<Vec2> vertices;  ///< mm
  std::vector<HalfEdge> edges;

  [[nodiscard]] std::size_t target(std::size_t h) const { return edges[h ^ 1].origin; }
};

/// By Fortune's sweep line (Boost.Polygon) on a grid of whole numbers, turned by `angle` radians. O(n log n).
VoronoiGraph sweepLineGraph(const Boundary&, double angle, const Progress&);
/// As the dual of CGAL's segment Delaunay graph, by exact predicates; some fifty times slower.
VoronoiGraph delaunayGraph(const Boundary&, const Progress&);

}  // namespace blossom::pocket
