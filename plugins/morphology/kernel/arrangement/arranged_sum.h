#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

namespace arrangement {
struct FeaturePairs;
}

/// A shape times a factor, as it enters a sum: a solid, or what is thinner. @pre coordinates on the grid
struct Term {
  const Mesh& triangles;                      ///< closed, oriented; without faces: the pieces count
  std::span<const std::vector<Vec3>> pieces;  ///< triangles, segments or points
  double factor = 1;                          ///< not 0; below 0 the shape is mirrored in the origin
};

struct ArrangedSum {
  Mesh triangles;  ///< closed and oriented; corners are rounded to doubles. Without faces: it has no volume
  /// Facets that may bound it: of corners of a and faces of b, of faces of a and corners of b, of edges.
  std::array<std::size_t, 3> candidates{};
  std::size_t leftOut = 0;  ///< of these: deep inside, not arranged
  double candidatesMs = 0, arrangementMs = 0, cellsMs = 0;
};

/// a + b, without taking anything apart: the facets of the three families of the paper (section 2.2) are cut along each
/// other in exact arithmetic, and those before which there is no sum are its boundary. Terms are scaled, then rounded to the
/// grid: nothing where that leaves triangles without area. Bodies of a solid may overlap. Parts of the sum without volume
/// are left out. O((n + m) log n) for the pairs of n and m features, O(k log k) for k facets that meet.
/// @param kept what `keptPairs` found for the same solids  @pre sums reach no further than 2^60 steps. @throws Error
/// Cancelled.
std::optional<ArrangedSum> arrangedSum(const Term& a, const Term& b, double step, const Progress&,
                                       const arrangement::FeaturePairs* kept = nullptr);

/// The pairs of features that can make facets of sums of two solids at any factors from `leastFactor` to 1, of which each
/// sum then takes those that do. (The candidates do not depend on the factors but for rounding.) Nothing when the solids
/// have triangles without area. @throws Error Cancelled.
std::shared_ptr<const arrangement::FeaturePairs> keptPairs(const Term& a, const Term& b, double step, double leastFactor,
                                                           const Progress&);

/// {x : x + b inside a}: the complement of the sum of the complement of a solid and the mirrored b. @pre bodies of the solid
/// do not overlap
std::optional<ArrangedSum> arrangedDifference(const Term& a, const Term& b, double step, const Progress&);

/// A facet that may bound a sum.
struct SumFacet {
  std::size_t family = 0;     ///< what it is made of, as in `ArrangedSum::candidates`
  std::vector<Vec3> corners;  ///< counter-clockwise from outside
};

/// All facets that may bound the sum, before they are cut. Nothing where the shapes, on the grid, have triangles without
/// area. @throws Error Cancelled.
std::optional<std::vector<SumFacet>> sumFacets(const Term& a, const Term& b, double step, const Progress&);

/// The ends of the reflex edges of a solid.
std::vector<Vec3> reflexCorners(const Term&, double step);

}  // namespace blossom::morphology
