#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/polygons.h"

/// Morphs by vertices: the commonest way, with which the morph by Minkowski sums is compared.
namespace blossom::minkowski {

using namespace planar;

/// Outlines of two shapes with points that belong together, as many in the one as in the other.
struct MatchedOutlines {
  std::vector<Loop> first, second;
};

/// Why the outlines of two shapes cannot be matched: a full sentence; empty when they can, which takes equally many outlines
/// and no holes.
std::string whyUnmatched(const Polygons& first, const Polygons& second);

/// Matches points at equal shares of the length of their outlines, so that each corner of one shape gets a point of the
/// other. The outlines start where the mean square distance of matched points is least once the means of both outlines
/// coincide: the best of 512 starts and its rivals, refined to the zero of the derivative. Of several outlines those go
/// together whose centroids are nearest, nearest pair first. O(n log n + p^2) for n corners and p parts. @pre whyUnmatched
/// says nothing.
/// @throws Error Cancelled
MatchedOutlines matchedOutlines(const Polygons& first, const Polygons& second, const Progress& = Progress::none());

/// Every point on the line to the one that belongs to it: at t = 0 the first shape, at 1 the second.
std::vector<Loop> inBetween(const MatchedOutlines&, double t);

/// How many pairs of edges cross, of one outline or of two. Outlines that only touch may count 2 for each touch. O(n log n +
/// k) for k pairs that come near. @throws Error Cancelled
std::size_t crossingsOf(const std::vector<Loop>&, const Progress& = Progress::none());

}  // namespace blossom::minkowski
