#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/planar/region.h"
#include "geometry/planar/winding/winding_faces.h"

/// What CGAL makes of the same planar input: the oracle of minkowski's boundaries and the peer of its speed. It takes most
/// of a minute to compile, so that is done once.
namespace blossom::test {

/// What edges wind around, read off the faces of CGAL's exact arrangement. Nothing is walked: parts and holes are counted by
/// flooding faces.
struct ArrangedFaces {
  double area = 0;
  std::size_t parts = 0;                        ///< whose faces are connected across edges
  std::size_t holes = 0;                        ///< of each part, what is enclosed by it
  std::vector<std::pair<Vec2, Vec2>> boundary;  ///< with the inside to the left
};
ArrangedFaces arrangedFaces(std::span<const planar::CountedEdge>, planar::Inside);

/// CGAL's Minkowski sum of two regions by reduced convolution, of parts united; called, it computes it and returns the area.
/// @pre straight edges; loops that touch neither themselves nor one another
std::function<double()> reducedConvolution(const Region&, const Region&);

}  // namespace blossom::test
