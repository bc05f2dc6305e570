#pragma once
#include <cstddef>
#include <vector>

#include "core/vector.h"
#include "geometry/planar/region.h"

namespace blossom {

/// A point with three or more nearest points of the boundary, a leaf, or a corner (clearance 0).
struct MedialVertex {
  Vec2 at;
  double clearance = 0;    ///< mm, radius of the largest disc around it
  bool certified = false;  ///< the disc was checked to hold no boundary
  friend bool operator==(const MedialVertex&, const MedialVertex&) = default;
};

/// A curve of centres of discs that touch the boundary twice.
struct MedialEdge {
  std::size_t from = 0, to = 0;  ///< vertices
  std::vector<Vec3> points;      ///< x, y and clearance along it, both ends included, straight between
  friend bool operator==(const MedialEdge&, const MedialEdge&) = default;
};

/// The medial axis of a region: the centres of all discs in it that no other disc in it holds.
struct MedialAxis {
  std::vector<MedialVertex> vertices;
  std::vector<MedialEdge> edges;
  friend bool operator==(const MedialAxis&, const MedialAxis&) = default;
};

/// mm of all edges.
double lengthOf(const MedialAxis&);
/// The edges as open paths of lines: what a drawing of it holds.
Curves drawingOf(const MedialAxis&);

}  // namespace blossom
