#pragma once
#include <optional>
#include <vector>

#include "geometry/planar/medial_axis.h"
#include "kernel/medial/voronoi_graph.h"

namespace blossom::pocket {

/// What the disc around a point of a chain touches.
struct Touched {
  Site left, right;
  std::optional<BoundaryFoot> leaf;  ///< both feet are here
};

/// A chain of edges of the diagram that becomes an edge of the medial axis.
struct Chain {
  std::size_t from = 0, to = 0;  ///< vertices of the axis
  std::vector<Vec3> points;      ///< x, y and clearance
  std::vector<Touched> touched;  ///< of each point
};

/// Leaves out points, as many as a polyline within `tolerance` mm of the one given does not need (Douglas & Peucker 1973).
void thin(Chain&, double tolerance);

/// Vertices nearer than `apart` mm along a chain, which only rounding or the flattening keeps apart, become one; a vertex
/// where two chains meet and nothing branches is none. Vertices that are left get new numbers.
void joinNeighbours(std::vector<MedialVertex>&, std::vector<Chain>&, double apart);

}  // namespace blossom::pocket
