#pragma once
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <optional>
#include <vector>

#include "core/vector.h"
#include "geometry/bspline/surface.h"

/// Faces that are a whole rectangle of a B-spline surface; a structured grid meshes them far better than a general mesher.
namespace blossom {

enum class GridSide { V0, U1, V1, U0 };

/// An edge on a side of the rectangle. Its parameter is a linear function of the surface parameter along the side.
struct SideEdge {
  TopoDS_Edge edge;            ///< oriented as in the forward face
  double first = 0, last = 0;  ///< range of the edge's parameter
  double from = 0, to = 0;     ///< surface parameter along the side at `first` and `last`
  bool degenerated = false;

  [[nodiscard]] double low() const { return from < to ? from : to; }
  [[nodiscard]] double high() const { return from < to ? to : from; }
  [[nodiscard]] double onSide(double t) const { return from + (t - first) / (last - first) * (to - from); }
  [[nodiscard]] double onEdge(double s) const { return first + (s - from) / (to - from) * (last - first); }
};

struct GridFace {
  TopoDS_Face face;
  Surface surface;                             ///< restricted to the rectangle, in the local frame of the face
  Vec2 shift = Vec2::Zero();                   ///< from the parameters of `surface` to those of the face
  std::array<std::vector<SideEdge>, 4> sides;  ///< by Side, sorted by their parameter

  [[nodiscard]] const std::vector<SideEdge>& side(GridSide s) const { return sides[static_cast<std::size_t>(s)]; }
};

/// The face as a rectangle whose sides are covered by edges (seams and degenerate edges included); empty for any other face.
/// Periodic and trimmed surfaces are restricted to the rectangle.
std::optional<GridFace> gridFace(const TopoDS_Face&);

}  // namespace blossom
