#pragma once
#include <TopoDS_Shape.hxx>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/bspline/surface.h"
#include "geometry/numeric/boxes.h"

/// Triangles that remember where on their smooth face they lie, for the search of places where faces cross.
namespace blossom {

struct SheetTriangle {
  std::array<int, 3> corners{};
  std::array<Vec2, 3> at;  ///< parameters of the corners on the face
  int face = 0;
};

/// Directions within `halfAngle` of `axis`; empty when the axis is zero.
struct DirectionCone {
  Vec3 axis = Vec3::Zero();  ///< unit length
  double halfAngle = 0;      ///< radians
};

/// The smallest cone about the bisector of the axes that holds both.
DirectionCone joinedCone(const DirectionCone&, const DirectionCone&);

/// Neighbouring triangles, which are searched together.
struct SheetBlock {
  std::uint32_t first = 0, count = 0;  ///< of SheetMesh::triangles
  Box3 box;
  Vec3 normal = Vec3::Zero();    ///< of the triangles on the average, unit length or zero
  DirectionCone alongU, alongV;  ///< of the sides of its cells; only of a grid
};

struct SheetMesh {
  /// Corners are one point where a seam, an edge or a pole of the surface joins them; not where sheets merely meet.
  std::vector<Vec3> points;
  std::vector<SheetTriangle> triangles;
  std::vector<SheetBlock> blocks;
  std::size_t blocksU = 0, blocksV = 0;   ///< of a grid, block (i, j) is i * blocksV + j; else 0
  bool closedU = false, closedV = false;  ///< of a grid: its first and last rows are joined
  double size = 0;                        ///< mm, diagonal of the box around all points
  double chord = 0;                       ///< mm, how far the triangles may be off the faces

  [[nodiscard]] std::array<Vec3, 3> at(const SheetTriangle& t) const {
    return {points[static_cast<std::size_t>(t.corners[0])], points[static_cast<std::size_t>(t.corners[1])],
            points[static_cast<std::size_t>(t.corners[2])]};
  }
};

/// The box around points of a surface, four or more to a span either way: that of the poles may be far larger, as one of a
/// small weight lies anywhere.
Box3 sampledBox(const Surface&, const Progress& = Progress::none());

/// Its diagonal, mm.
double sampledSize(const Surface&, const Progress& = Progress::none());

/// A grid of the whole surface within `chord`, in blocks of 8 x 8 cells. @throws as tessellate.
SheetMesh sheetMesh(const Surface&, double chord, const Progress& = Progress::none());

/// All faces of a shape within `chord`, numbered as TopExp::MapShapes does, in blocks that lie near together; oriented as
/// the faces are. @throws as tessellate.
SheetMesh sheetMesh(const TopoDS_Shape&, double chord, const Progress& = Progress::none());

/// The same within about that share of the shape's own size (1.25 times it at most), be the poles of its faces ever so far
/// away. @throws as tessellate.
SheetMesh sheetMeshWithin(double share, const TopoDS_Shape&, const Progress& = Progress::none());

}  // namespace blossom
