#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/grid.h"

namespace blossom::minkowski {

using namespace planar;

/// A height as weights of the two sets: `first` of the lower one and `second` of the upper one, their sum is positive.
struct LoftLevel {
  std::int64_t first = 1, second = 0;
};

/// What an edge of the convolution of (1-t) A and t B sweeps while t runs from 0 to 1: a triangle, for an edge of one set is
/// moved by a corner of the other, or a trapezoid once cut off at a level. At t the edge runs from (1-t) from[0] + t from[1]
/// to the same of `to`, always in the direction `along`, on the line cross(along, x) = (1-t) offset[0] + t offset[1].
struct LoftFacet {
  GridPoint from[2], to[2];  ///< at the bottom and at the top
  GridPoint along;           ///< with x > 0, or x = 0 and y > 0
  Wide offset[2] = {0, 0};
  int count = 1;                    ///< what the winding number is larger on the left
  bool mayBound = true;             ///< false when it never bounds what is inside
  int firstSlab = 0, lastSlab = 0;  ///< between which levels it counts
  int plane = 0;                    ///< number of its plane
};

/// A plane of facets in its one form: `along` without a common divisor.
struct LoftPlane {
  GridPoint along;
  Wide offset[2] = {0, 0};
};

struct LoftFacets {
  std::vector<LoftFacet> facets;
  std::vector<LoftPlane> planes;
  std::vector<LoftLevel> levels;  ///< ascending from the bottom to the top: slab i lies between levels i and i + 1
};

/// All facets of the loft from A to B. Within each slab the winding number of their edges at (x, t) is positive exactly when
/// x lies in (1-t) A + t B: holes that the other set cannot enter are filled (see convolution), which changes with t, so
/// that the levels lie where it does. O(k log k) for k pairs of edges and corners. @throws Error LimitExceeded, Cancelled.
LoftFacets loftFacets(std::span<const GridPolygon> a, std::span<const GridPolygon> b, const Progress&);

}  // namespace blossom::minkowski
