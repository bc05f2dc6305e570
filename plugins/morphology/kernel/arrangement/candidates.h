#pragma once
#include <vector>

#include "core/progress.h"
#include "kernel/arrangement/pairs.h"
#include "kernel/arrangement/points.h"
#include "kernel/arrangement/sum_core.h"

namespace blossom::morphology::arrangement {

/// Which features of two solids a facet of their sum is made of.
enum class Family : std::uint8_t { CornerAndFace, FaceAndCorner, EdgeAndEdge };

/// A convex polygon that may bound a sum. All of it lies in the sum, which continues behind it.
struct Facet {
  int plane = 0;
  bool sameWay = true;  ///< outward is where the normal of the plane points to
  Family family = Family::EdgeAndEdge;
  std::array<int, 4> corners{};  ///< points, counter-clockwise from outside
  std::size_t count = 3;         ///< of corners

  [[nodiscard]] int corner(std::size_t k) const { return corners[k % count]; }
};

/// How many facets there are of each family.
using FacetCounts = std::array<std::size_t, 3>;

struct Candidates {
  std::vector<Facet> facets;
  FacetCounts found{};      ///< by their families
  std::size_t leftOut = 0;  ///< of those found: in the core
};

/// Facets that cover the boundary of a + b: a face of one at a corner of the other that its normal supports, and
/// parallelograms of two convex edges whose common normal supports both (the paper's DHS test, on triangles), of the given
/// pairs; without those in the core of the sum, if one is given. @throws Error Cancelled.
Candidates candidates(const Features& a, const Features& b, const FeaturePairs&, const SumCore*, Planes&, Points&,
                      const Progress&);

}  // namespace blossom::morphology::arrangement
