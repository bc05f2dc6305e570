#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/progress.h"
#include "geometry/crossing/sheet_mesh.h"

namespace blossom {

/// Two triangles that meet elsewhere than in what they share.
struct TrianglePair {
  std::uint32_t first = 0, second = 0;
  Vec3 place = Vec3::Zero();  ///< a common point
  double height = 0;          ///< mm, how far the less slanted of the two leaves the other's plane
};

struct MeetingTriangles {
  std::vector<TrianglePair> pairs;  ///< the greatest heights first
  /// Pairs of one plane that look opposite ways and cover the same places, of which there may be many: the first ones.
  std::vector<TrianglePair> lying;
  /// The same of pairs that look the same way, where what they cover in common is wider than about 1/5000 of the size.
  std::vector<TrianglePair> alike;
};

/// Pairs of triangles that meet, in doubles. Blocks that cannot meet are left out by their boxes, by a plane between them
/// and, where they touch within a grid, by the cones of their sides: two points of a rectangle of cells are joined by a path
/// along u and then along v, so they differ unless a direction along u is opposite or equal to one along v. Neighbours over
/// a side are not tested: a fold shows among their neighbours. Of more than `most` pairs those with the greatest heights.
/// About O(n) for surfaces that seldom come near themselves. @throws Error Cancelled.
MeetingTriangles meetingTriangles(const SheetMesh&, std::size_t most, const Progress&);

}  // namespace blossom
