#pragma once
#include <cstddef>
#include <vector>

#include "core/vector.h"
#include "geometry/planar/region.h"

namespace blossom {

/// A point with three or more nearest boundary points, a leaf, or a corner (clearance 0).
struct MedialVertex {
  Vec2 at;
  double clearance = 0;    ///< mm, radius of the largest disc around the vertex inside the region
  bool certified = false;  ///< the disc was verified to contain no boundary point
  friend bool operator==(const MedialVertex&, const MedialVertex&) = default;
};

/// Where a disc touches the boundary.
struct BoundaryFoot {
  std::size_t loop = 0, segment = 0;  ///< of the region
  double parameter = 0;               ///< 0 to 1 along a line or an arc, of a spline its own
  Vec2 at = Vec2::Zero();
  friend bool operator==(const BoundaryFoot&, const BoundaryFoot&) = default;
};

/// The two feet of a disc, seen along the edge. They are one at the end of an edge in a corner or at a centre of curvature.
struct MedialFeet {
  BoundaryFoot left, right;
  friend bool operator==(const MedialFeet&, const MedialFeet&) = default;
};

/// A curve of centres of discs that touch the boundary in two points.
struct MedialEdge {
  std::size_t from = 0, to = 0;  ///< vertices
  std::vector<Vec3> points;      ///< x, y and clearance along the edge, both ends included; linear between
  std::vector<MedialFeet> feet;  ///< of each point
  friend bool operator==(const MedialEdge&, const MedialEdge&) = default;
};

/// The medial axis of a region: the centres of all maximal discs in it.
struct MedialAxis {
  std::vector<MedialVertex> vertices;
  std::vector<MedialEdge> edges;
  friend bool operator==(const MedialAxis&, const MedialAxis&) = default;
};

/// Total length of the edges, mm.
double lengthOf(const MedialAxis&);
/// The edges as open paths of lines, for drawings.
Curves drawingOf(const MedialAxis&);

}  // namespace blossom
