#pragma once
#include <array>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::subdivision {

/// A face in a cell.
struct PlacedFace {
  int face = 0;
  int turn = 0;  ///< index of the face's corner that is lower left in the cell
};

/// A rectangle of faces.
struct LayoutCell {
  int columns = 0, rows = 0;
  std::vector<PlacedFace> faces;          ///< row by row
  std::array<int, 4> corners{};           ///< vertices: lower left, lower right, upper right, upper left
  std::array<bool, 4> irregularCorner{};  ///< the surface near that corner is not a bicubic polynomial
  [[nodiscard]] const PlacedFace& at(int column, int row) const {
    return faces[static_cast<std::size_t>(row * columns + column)];
  }
};

/// Divides a mesh of quads into few rectangles that are adjacent along whole sides: along its sharp edges, and along
/// straight lines from all irregular vertices to the next such line or the border. Irregular vertices are only at corners of
/// cells. O(n log n).
/// @pre `checkCage` accepts the mesh, all faces are quads, sharp edges have sharpness 10 or more.
/// @param looked set to the number of placements of faces, including repeated ones after a cut
std::vector<LayoutCell> quadLayout(const Mesh&, const Progress& = Progress::none(), std::size_t* looked = nullptr);

}  // namespace blossom::subdivision
