#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "exchange/dxf/dxf_groups.h"
#include "geometry/planar/region.h"

namespace blossom {

/// Layer and colour of an entity as written in the file.
struct DxfInk {
  std::string layer = "0";
  int index = 256;  ///< AutoCAD colour index; 0: BYBLOCK, 256: BYLAYER
  int rgb = -1;     ///< 0xrrggbb; -1: none
};

/// A reference to a block at a point, or at the points of a grid.
struct DxfInsert {
  std::string block;
  Eigen::Matrix<double, 2, 3> plane;  ///< from the plane of the entity to the drawing
  Vec2 at{0, 0}, scale{1, 1}, spacing{0, 0};
  double angle = 0;  ///< radians
  int columns = 1, rows = 1;
};

struct DxfItem {
  DxfInk ink;
  Path path;                        ///< layer and colour are not set yet
  std::optional<DxfInsert> insert;  ///< instead of a path
  std::size_t line = 0;
};

struct DxfBlock {
  Vec2 base{0, 0};
  std::vector<DxfItem> items;
};

/// Content of the file: blocks not yet inserted, lengths in the unit of the file.
struct DxfDrawing {
  DxfBlock model;
  std::map<std::string, DxfBlock> blocks;  ///< by name in capitals
  std::map<std::string, DxfInk> layers;
  int unit = 0;  ///< $INSUNITS
  std::size_t flattened = 0, interpolated = 0, degenerate = 0;
  std::optional<Vec2> point;  ///< of a line without length outside of blocks
};

/// Interprets the cleaned text with dxflib. @throws Error FormatDamaged, Cancelled.
DxfDrawing readDxfDrawing(const CleanDxf&, const Progress&);

/// Whether a drawing is nothing but one line without length, which stands for a point.
bool isPoint(const DxfDrawing&);

/// Inserts all blocks and converts lengths to mm.
/// @throws Error FormatDamaged for a block that contains itself or does not exist, LimitExceeded for arrays that are too
/// large.
Curves expandDxf(const DxfDrawing&, std::vector<std::string>& warnings, const Progress&);

/// Circular arc between two points with bulge = tan(sweep / 4); a line when the bulge is 0.
Segment bulgeSegment(const Vec2& from, const Vec2& to, double bulge);
/// The plane of an entity with an extrusion direction (arbitrary axis algorithm of the DXF reference), projected along z.
Eigen::Matrix<double, 2, 3> dxfPlane(Vec3 extrusion, double elevation);
/// Colour of an AutoCAD colour index; empty for 7, which is black on paper and white on a dark screen.
std::optional<Color> dxfColor(int index);
int nearestDxfColor(const Color&);

}  // namespace blossom
