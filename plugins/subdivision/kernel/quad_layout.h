#pragma once
#include <array>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::subdivision {

/// A face in its place in a cell.
struct PlacedFace {
  int face = 0;
  int turn = 0;  ///< which corner of the face is its lower left one there
};

/// A rectangle of faces.
struct LayoutCell {
  int columns = 0, rows = 0;
  std::vector<PlacedFace> faces;          ///< row by row
  std::array<int, 4> corners{};           ///< vertices: lower left, lower right, upper right, upper left
  std::array<bool, 4> irregularCorner{};  ///< the surface near that corner is no bicubic polynomial
  [[nodiscard]] const PlacedFace& at(int column, int row) const {
    return faces[static_cast<std::size_t>(row * columns + column)];
  }
};

/// A mesh of quads cut into few rectangles that meet side to side: along its sharp edges, and along straight lines from all
/// its irregular vertices, which run on until they meet another one or the rim. Irregular vertices are corners of cells
/// only. O(n log n).
/// @pre `checkCage` accepts the mesh, all faces are quads, sharp edges have sharpness 10 or more.
/// @param looked set to how many faces were placed in all, those placed again after a cut counted again
std::vector<LayoutCell> quadLayout(const Mesh&, const Progress& = Progress::none(), std::size_t* looked = nullptr);

}  // namespace blossom::subdivision
