#pragma once
#include <vector>

#include "kernel/solid/loft_facets.h"
#include "kernel/solid/loft_predicates.h"

namespace blossom::minkowski {

/// An edge of the loft's boundary as a side of one of its faces, which lies to its left seen from outside.
struct LoftSide {
  LoftPredicates::Place from, to;
  int plane = 0;             ///< or bottomPlane or topPlane
  bool outsideLeft = false;  ///< whether the outside is where the plane's direction has its left
};
constexpr int bottomPlane = -1, topPlane = -2;

/// A place on the line of a facet at a height: where another facet's line meets it, or an end of a facet that lies on it.
struct PlaceOnLine {
  int facet = 0;
  int end = -1;  ///< -1: where the lines meet
};

/// Facets with what is asked about them.
struct LoftScene {
  const LoftFacets& loft;
  const LoftPredicates& predicates;
  const std::vector<std::vector<int>>& neighbours;
  const std::vector<LoftTime>& levels;  ///< the same as loft.levels

  [[nodiscard]] const LoftFacet& facet(int i) const { return loft.facets[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const std::vector<int>& near(int i) const { return neighbours[static_cast<std::size_t>(i)]; }
  [[nodiscard]] bool counts(int i, int slab) const { return facet(i).firstSlab <= slab && slab <= facet(i).lastSlab; }
  [[nodiscard]] int slabs() const { return static_cast<int>(levels.size()) - 1; }

  /// Along the line of facet i at a height: -1 when a comes before b.
  [[nodiscard]] int order(int i, const PlaceOnLine& a, const PlaceOnLine& b, const LoftTime&) const;
  /// The winding number a trace beyond a place on the line of facet i, and a still smaller trace to its left.
  [[nodiscard]] int windingBeyond(int i, const PlaceOnLine&, const LoftTime&, int slab) const;
};

}  // namespace blossom::minkowski
