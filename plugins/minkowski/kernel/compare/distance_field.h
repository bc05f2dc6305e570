#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/polygons.h"

/// Morphs by distance fields (Cohen-Or, Levin & Solomovici 1998, without their warp), with which the morph by Minkowski sums
/// is compared.
namespace blossom::minkowski {

using namespace planar;

/// Nodes of a square grid, row by row from the lower left.
struct FieldGrid {
  Vec2 origin = Vec2::Zero();
  double step = 1;  ///< mm
  std::size_t columns = 0, rows = 0;

  [[nodiscard]] std::size_t nodes() const { return columns * rows; }
  [[nodiscard]] Vec2 node(std::size_t column, std::size_t row) const {
    return origin + step * Vec2(static_cast<double>(column), static_cast<double>(row));
  }
};

/// A grid with `cells` cells along the longer side of a box, and one more all around it.
FieldGrid fieldGrid(const Box2&, std::size_t cells);

/// Distances of the nodes from the boundary in mm, negative inside. To the polygons exact but for rounding. O(nodes log
/// edges) for well-distributed edges, on all cores. @throws Error Cancelled
std::vector<double> signedDistances(const Polygons&, const FieldGrid&, const Progress& = Progress::none());

/// (1-t) a + t b
std::vector<double> blendedField(const std::vector<double>& a, const std::vector<double>& b, double t);

/// The outlines of where a field is negative, by marching squares: outer loops counter-clockwise, holes clockwise. The field
/// is taken as linear along the sides of the cells; where a cell is cut twice, the mean of its corners decides. No loop
/// touches another or itself. O(nodes). @pre the field is not negative along the border of the grid. @throws Error Cancelled
std::vector<Loop> negativeOutlines(const std::vector<double>& field, const FieldGrid&, const Progress& = Progress::none());

}  // namespace blossom::minkowski
